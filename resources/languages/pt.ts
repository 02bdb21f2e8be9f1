<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt" sourcelanguage="en">
<context>
<name>EdgeScan</name>
<message><source>CONNECTING</source><translation>CONECTANDO</translation></message>
<message><source>LIVE</source><translation>AO VIVO</translation></message>
<message><source>STALE</source><translation>DESATUALIZADO</translation></message>
<message><source>STALE %1</source><translation>DESATUALIZADO %1</translation></message>
<message><source>NOT CONNECTED</source><translation>SEM CONEXÃO</translation></message>
<message><source>LOST %1</source><translation>PERDIDO %1</translation></message>
<message><source>STOPPED</source><translation>PARADO</translation></message>
<message><source>STOPPED %1</source><translation>PARADO %1</translation></message>
<message><source>%1, COUNTERS IN DOUBT</source><translation>%1, CONTADORES DUVIDOSOS</translation></message>
<message><source>INCOMPLETE %1 lines</source><translation>INCOMPLETO %1 linhas</translation></message>
<message><source>%1 lost: %2</source><translation>%1 perdidas: %2</translation></message>
<message><source>%1 lines</source><translation>%1 linhas</translation></message>
<message><source>no return %1 %</source><translation>sem retorno %1 %</translation></message>
<message><source>COUNTERS IN DOUBT</source><translation>CONTADORES DUVIDOSOS</translation></message>
<message><source>MOUNTING ASSUMED</source><translation>MONTAGEM SUPOSTA</translation></message>
<message><source>MOUNTING FROM RANGES</source><translation>MONTAGEM PELAS DISTÂNCIAS</translation></message>
<message><source>FIRST ANGLE ASSUMED</source><translation>PRIMEIRO ÂNGULO SUPOSTO</translation></message>
<message><source>STEP ASSUMED %1°</source><translation>PASSO SUPOSTO %1°</translation></message>
<message><source>START ASSUMED</source><translation>INÍCIO SUPOSTO</translation></message>
<message><source>1 remark</source><translation>1 observação</translation></message>
<message><source>%1 remarks</source><translation>%1 observações</translation></message>
<message><source>%1 earlier in this sweep</source><translation>%1 antes nesta varredura</translation></message>
<message><source>WINDOW TOO DIRTY</source><translation>JANELA SUJA DEMAIS</translation></message>
<message><source>WINDOW DIRTY</source><translation>JANELA SUJA</translation></message>
<message><source>DEVICE ERROR</source><translation>ERRO DO APARELHO</translation></message>
<message><source>pose %1 old</source><translation>pose de há %1</translation></message>
<message><source>%1 left</source><translation>faltam %1</translation></message>
<message><source>%1, %2 ago</source><translation>%1, há %2</translation></message>
<message><source>recording %1 MB, %2</source><translation>gravação %1 MB, %2</translation></message>
<message><source>recording %1 MB</source><translation>gravação %1 MB</translation></message>
<message><source>RECORDING ENDED: %1</source><translation>GRAVAÇÃO TERMINADA: %1</translation></message>
<message><source>RECORDING HAS GAPS: %1</source><translation>A GRAVAÇÃO TEM FALHAS: %1</translation></message>
<message><source>%1; other cells: points of one moved to the grid of the other</source><translation>%1; outras células: pontos de uma levados para a grade da outra</translation></message>
<message><source>one scan with two settings</source><translation>uma varredura com dois ajustes</translation></message>
<message><source>lined up by their poses</source><translation>alinhados pelas suas poses</translation></message>
<message><source>lined up by given positions of the scanner, not in the mine grid</source><translation>alinhados por posições dadas do scanner, não na grade da mina</translation></message>
<message><source>no pose: lined up by their surfaces</source><translation>sem pose: alinhados pelas suas superfícies</translation></message>
<message><source>not resolved</source><translation>não resolvido</translation></message>
<message><source>sweep %1</source><translation>varredura %1</translation></message>
<message><source>demo draw-bell after the blast</source><translation>sino de demonstração após o desmonte</translation></message>
<message><source>demo draw-bell</source><translation>sino de demonstração</translation></message>
<message><source>there is not enough memory for this scan</source><translation>não há memória suficiente para esta varredura</translation></message>
<message><source>close other programs or open a smaller scan</source><translation>feche outros programas ou abra uma varredura menor</translation></message>
<message><source>there is not enough memory to show the scan in its place</source><translation>não há memória suficiente para mostrar a varredura no seu lugar</translation></message>
<message><source>there is not enough memory for this layer</source><translation>não há memória suficiente para esta camada</translation></message>
<message><source>there is not enough memory for a second picture</source><translation>não há memória suficiente para uma segunda imagem</translation></message>
<message><source>there is not enough memory for a second scan</source><translation>não há memória suficiente para uma segunda varredura</translation></message>
<message><source>there is not enough memory for these scans</source><translation>não há memória suficiente para estas varreduras</translation></message>
<message><source>there is not enough memory to play this recording</source><translation>não há memória suficiente para reproduzir esta gravação</translation></message>
<message><source>hide or remove other layers, or choose a smaller scan</source><translation>oculte ou remova outras camadas, ou escolha uma varredura menor</translation></message>
<message><source>close other programs or choose a smaller scan</source><translation>feche outros programas ou escolha uma varredura menor</translation></message>
<message><source>close other programs or choose a smaller one</source><translation>feche outros programas ou escolha uma menor</translation></message>
<message><source>close other programs or use fewer scans</source><translation>feche outros programas ou use menos varreduras</translation></message>
<message><source>close other programs or use a smaller scan</source><translation>feche outros programas ou use uma varredura menor</translation></message>
<message><source>another program has changed this file, so it was not removed</source><translation>outro programa mudou este arquivo, por isso não foi removido</translation></message>
<message><source>open the scan again to see its edits</source><translation>abra a varredura de novo para ver as suas alterações</translation></message>
<message><source>it could not be opened (%1)</source><translation>não pôde ser aberto (%1)</translation></message>
<message><source>auto is not a number</source><translation>auto não é um número</translation></message>
<message><source>tick auto next to the box</source><translation>marque auto ao lado do campo</translation></message>
<message><source>the layer has another content than when it was placed</source><translation>a camada tem outro conteúdo do que quando foi colocada</translation></message>
<message><source>remove it and add it again</source><translation>remova-a e adicione-a de novo</translation></message>
<message><source>it is not a regular file, so settings are not read and nothing of this window is stored</source><translation>não é um arquivo comum: os ajustes não são lidos e nada desta janela é guardado</translation></message>
<message><source>remove it and start again</source><translation>remova-o e inicie de novo</translation></message>
<message><source>not all settings in this file can be read</source><translation>nem todos os ajustes deste arquivo podem ser lidos</translation></message>
<message><source>what it held is in </source><translation>o que ele continha está em </translation></message>
<message><source>choose another scan</source><translation>escolha outra varredura</translation></message>
<message><source> (line </source><translation> (linha </translation></message>
<message><source>Both are one scan: the files are the same.</source><translation>Ambos são uma só varredura: os arquivos são iguais.</translation></message>
<message><source>Near and far leave no depth between them: the gray image is blank and has no edge.</source><translation>Perto e longe não deixam profundidade entre si: a imagem cinza está vazia e não tem arestas.</translation></message>
<message><source> edge cells lie on filled ranges and are not in this file; %1 writes them.</source><translation> células de aresta estão em distâncias preenchidas e não estão neste arquivo; %1 as escreve.</translation></message>
<message><source>OUT OF SPEC: whether the surfaces of "%1" fit cannot be seen.</source><translation>FORA DE TOLERÂNCIA: não se pode ver se as superfícies de "%1" encaixam.</translation></message>
<message><source>OUT OF SPEC: the surfaces of "%1" are %2 mm from those of the first scan at best.</source><translation>FORA DE TOLERÂNCIA: as superfícies de "%1" estão, no melhor caso, a %2 mm das da primeira varredura.</translation></message>
<message><source>OUT OF SPEC: the base moved while "%1" was taken: one place fits it badly.</source><translation>FORA DE TOLERÂNCIA: a base moveu-se enquanto "%1" era medida: um só lugar encaixa mal.</translation></message>
<message><source>OUT OF SPEC: without a pose of both, the two scans are lined up by their surfaces alone.</source><translation>FORA DE TOLERÂNCIA: sem pose das duas, as duas varreduras são alinhadas só pelas suas superfícies.</translation></message>
<message><source>OUT OF SPEC: the surfaces of the two scans do not lie where their poses put them: %1 apart, and %2 if one is moved by </source><translation>FORA DE TOLERÂNCIA: as superfícies das duas varreduras não estão onde as suas poses as põem: a %1, e a %2 se uma for movida por </translation></message>
<message><source>OUT OF SPEC: the surfaces of the two scans lie %1 apart at best, so most of the place changed or they are not scans of one place. No areas of change are given.</source><translation>FORA DE TOLERÂNCIA: as superfícies das duas varreduras estão, no melhor caso, a %1: quase tudo mudou ou não são varreduras de um mesmo lugar. Não se dão áreas de mudança.</translation></message>
<message><source>OUT OF SPEC: whether the poses fit cannot be seen, </source><translation>FORA DE TOLERÂNCIA: não se pode ver se as poses encaixam, </translation></message>
<message><source>OUT OF SPEC: the poses do not fit the surfaces, so the earlier scan was moved by its surfaces, by </source><translation>FORA DE TOLERÂNCIA: as poses não encaixam nas superfícies, portanto a varredura anterior foi movida pelas suas superfícies, por </translation></message>
<message><source>Scan &gt; Straighten Beams</source><translation>Varredura &gt; Endireitar os feixes</translation></message>
<message><source>Scan &gt; Keep Repeated Values</source><translation>Varredura &gt; Manter os valores repetidos</translation></message>
<message><source>the coordinates in the export dialog</source><translation>as coordenadas na caixa de exportação</translation></message>
<message><source>the points behind others in the export dialog</source><translation>os pontos atrás de outros na caixa de exportação</translation></message>
<message><source>the filled cells in the export dialog</source><translation>as células preenchidas na caixa de exportação</translation></message>
<message><source>the comments in the export dialog</source><translation>os comentários na caixa de exportação</translation></message>
<message><source>the filling of gaps in the Edges panel</source><translation>o preenchimento de falhas no painel de arestas</translation></message>
<message><source>the outlines in the picture</source><translation>os contornos na imagem</translation></message>
<message><source>“%1” in Scan &gt; How the Scan Is Read</source><translation>«%1» em Varredura &gt; Como a varredura é lida</translation></message>
<message><source>the angles of beams and lines and the axis in Scan &gt; How the Scan Is Read</source><translation>os ângulos de feixes e linhas e o eixo em Varredura &gt; Como a varredura é lida</translation></message>
<message><source>%1 to %2</source><translation>%1 a %2</translation></message>
<message><source>valid</source><translation>válida</translation></message>
<message><source>no return</source><translation>sem retorno</translation></message>
<message><source>device status</source><translation>estado do aparelho</translation></message>
<message><source>out of window</source><translation>fora da janela</translation></message>
<message><source>masked</source><translation>mascaradas</translation></message>
<message><source>lost</source><translation>perdidas</translation></message>
<message><source>Scan &gt; Sweep… takes what is right.</source><translation>Varredura &gt; Varredura… aceita o que é certo.</translation></message>
<message><source>▲ mounting from the ranges</source><translation>▲ montagem pelas distâncias</translation></message>
<message><source>▲ step assumed</source><translation>▲ passo suposto</translation></message>
<message><source>▲ mounting assumed</source><translation>▲ montagem suposta</translation></message>
<message><source>1 target</source><translation>1 alvo</translation></message>
<message><source>%1 targets</source><translation>%1 alvos</translation></message>
<message><source>1 rock</source><translation>1 rocha</translation></message>
<message><source>%1 rocks</source><translation>%1 rochas</translation></message>
<message><source>Fold this panel to the edge of the window</source><translation>Recolher este painel para o lado da janela</translation></message>
<message><source>Folded panels</source><translation>Painéis recolhidos</translation></message>
<message><source>Open %1</source><translation>Abrir %1</translation></message>
<message><source>Open folder</source><translation>Abrir a pasta</translation></message>
<message><source>Details</source><translation>Detalhes</translation></message>
<message><source>Copy</source><translation>Copiar</translation></message>
<message><source>Close</source><translation>Fechar</translation></message>
<message><source>Shows the next of the notes that were not closed</source><translation>Mostra a próxima das notas que não foram fechadas</translation></message>
<message><source>Error</source><translation>Erro</translation></message>
<message><source>Note</source><translation>Nota</translation></message>
<message><source>Done</source><translation>Concluído</translation></message>
<message><source>%1 of %2</source><translation>%1 de %2</translation></message>
<message><source>%1 MB</source><translation>%1 MB</translation></message>
<message><source>%1 kB</source><translation>%1 kB</translation></message>
<message><source>Saved %1%2, %3.</source><translation>Salvo %1%2, %3.</translation></message>
<message><source>Open</source><translation>Abrir</translation></message>
<message><source>No program of this computer opened %1.</source><translation>Nenhum programa deste computador abriu %1.</translation></message>
<message><source>Undo</source><translation>Desfazer</translation></message>
<message><source>Removed: %1.</source><translation>Removido: %1.</translation></message>
<message><source>Done again: %1.</source><translation>Refeito: %1.</translation></message>
<message><source>Undone: %1.</source><translation>Desfeito: %1.</translation></message>
<message><source>It is back.</source><translation>Está de volta.</translation></message>
<message><source>Redo</source><translation>Refazer</translation></message>
<message><source>Double-click: in exchange for the cloud, and back</source><translation>Duplo clique: no lugar da nuvem, e de volta</translation></message>
<message><source>All views again</source><translation>Todas as vistas de novo</translation></message>
<message><source>This view alone</source><translation>Só esta vista</translation></message>
<message><source>Replace the file?</source><translation>Substituir o arquivo?</translation></message>
<message><source>There is a file of this name already:</source><translation>Já existe um arquivo com este nome:</translation></message>
<message><source>There are files of these names already:</source><translation>Já existem arquivos com estes nomes:</translation></message>
<message><source>Replace</source><translation>Substituir</translation></message>
<message><source>... and %1 lines more</source><translation>... e mais %1 linhas</translation></message>
<message><source>&amp;Night</source><translation>&amp;Noite</translation></message>
<message><source>&amp;Day</source><translation>&amp;Dia</translation></message>
<message><source>&amp;Control-Room Gray</source><translation>&amp;Cinza de sala de controle</translation></message>
<message><source>right-click &gt; hold a finger on | clicked &gt; tapped | clicks &gt; taps | click &gt; tap</source><translation>clique com o botão direito em &gt; mantenha o dedo em | cliques &gt; toques | clique &gt; toque | clicar &gt; tocar | clicou &gt; tocou</translation></message>
<message><source>OK</source><translation>OK</translation></message>
<message><source>Save</source><translation>Salvar</translation></message>
<message><source>&amp;Yes</source><translation>&amp;Sim</translation></message>
<message><source>&amp;No</source><translation>&amp;Não</translation></message>
<message><source>Apply</source><translation>Aplicar</translation></message>
<message><source>Cu&amp;t</source><translation>Recor&amp;tar</translation></message>
<message><source>&amp;Copy</source><translation>&amp;Copiar</translation></message>
<message><source>&amp;Paste</source><translation>Co&amp;lar</translation></message>
<message><source>Select All</source><translation>Selecionar tudo</translation></message>
<message><source>Discard</source><translation>Descartar</translation></message>
<message><source>Delete</source><translation>Excluir</translation></message>
<message><source>&amp;Step up</source><translation>&amp;Aumentar</translation></message>
<message><source>Step &amp;down</source><translation>&amp;Diminuir</translation></message>
<message><source>Copy &amp;Link Location</source><translation>Copiar o endereço do &amp;link</translation></message>
<message><source>Float</source><translation>Destacar</translation></message>
<message><source>Shift</source><translation>Shift</translation></message>
<message><source>Del</source><translation>Del</translation></message>
<message><source>PgUp</source><translation>PgUp</translation></message>
<message><source>PgDown</source><translation>PgDn</translation></message>
<message><source>Cancel</source><translation>Cancelar</translation></message>
<message><source>Look in:</source><translation>Procurar em:</translation></message>
<message><source>Back</source><translation>Trás</translation></message>
<message><source>Forward</source><translation>Avançar</translation></message>
<message><source>Go back</source><translation>Retroceder</translation></message>
<message><source>Go forward</source><translation>Ir adiante</translation></message>
<message><source>Parent Directory</source><translation>Pasta acima</translation></message>
<message><source>Go to the parent directory</source><translation>Ir para a pasta acima</translation></message>
<message><source>Create New Folder</source><translation>Criar pasta</translation></message>
<message><source>Create a New Folder</source><translation>Criar uma pasta nova</translation></message>
<message><source>List View</source><translation>Vista em lista</translation></message>
<message><source>Change to list view mode</source><translation>Mudar para a vista em lista</translation></message>
<message><source>Detail View</source><translation>Vista detalhada</translation></message>
<message><source>Change to detail view mode</source><translation>Mudar para a vista detalhada</translation></message>
<message><source>Sidebar</source><translation>Barra lateral</translation></message>
<message><source>List of places and bookmarks</source><translation>Lista de lugares e marcadores</translation></message>
<message><source>Files</source><translation>Arquivos</translation></message>
<message><source>File &amp;name:</source><translation>&amp;Nome do arquivo:</translation></message>
<message><source>Files of type:</source><translation>Tipo de arquivos:</translation></message>
<message><source>Directory:</source><translation>Pasta:</translation></message>
<message><source>&amp;Open</source><translation>&amp;Abrir</translation></message>
<message><source>&amp;Save</source><translation>&amp;Salvar</translation></message>
<message><source>&amp;Choose</source><translation>&amp;Escolher</translation></message>
<message><source>&amp;Rename</source><translation>&amp;Renomear</translation></message>
<message><source>&amp;Delete</source><translation>&amp;Excluir</translation></message>
<message><source>Show &amp;hidden files</source><translation>Mostrar arquivos &amp;ocultos</translation></message>
<message><source>&amp;New Folder</source><translation>&amp;Nova pasta</translation></message>
<message><source>Name</source><translation>Nome</translation></message>
<message><source>Size</source><translation>Tamanho</translation></message>
<message><source>Type</source><translation>Tipo</translation></message>
<message><source>Date Modified</source><translation>Modificado</translation></message>
<message><source>Computer</source><translation>Computador</translation></message>
<message><source>Drive</source><translation>Unidade</translation></message>
<message><source>All Files (*)</source><translation>Todos os arquivos (*)</translation></message>
<message><source>Show </source><translation>Mostrar </translation></message>
<message><source>Scroll Left</source><translation>Rolar para a esquerda</translation></message>
<message><source>Scroll Right</source><translation>Rolar para a direita</translation></message>
<message><source>▲ AUDIT LOG: %1</source><translation>▲ REGISTRO DE AUDITORIA: %1</translation></message>
<message><source>The audit log is written again; no line is missing.</source><translation>O registro de auditoria volta a ser escrito; não falta nenhuma linha.</translation></message>
<message><source>▲ AUDIT LOG: what is done is not noted (%1)</source><translation>▲ REGISTRO DE AUDITORIA: o que é feito não é anotado (%1)</translation></message>
<message><source>The two pictures could not be compared (%1); keep a smaller scan.</source><translation>Não foi possível comparar as duas imagens (%1); guarde uma varredura menor.</translation></message>
<message><source>There is no picture to keep yet: open a scan first.</source><translation>Ainda não há imagem para guardar: abra primeiro uma varredura.</translation></message>
<message><source>Keep as A</source><translation>Guardar como A</translation></message>
<message><source>Forget A</source><translation>Esquecer A</translation></message>
<message><source>The comparison ended: B, %1, is on the screen.</source><translation>A comparação terminou: B, %1, está na tela.</translation></message>
<message><source>Open A</source><translation>Abrir A</translation></message>
<message><source>The comparison ended: A was forgotten.</source><translation>A comparação terminou: A foi esquecido.</translation></message>
<message><source>A was forgotten: the demo and %1 are not of one place.</source><translation>A foi esquecido: a demonstração e %1 não são de um mesmo lugar.</translation></message>
<message><source>The comparison ended, because another scan was opened.</source><translation>A comparação terminou porque outro escaneamento foi aberto.</translation></message>
<message><source>There is nothing to compare with it yet: open the later scan first.</source><translation>Ainda não há nada com que comparar: abra primeiro a varredura posterior.</translation></message>
<message><source>Reading %1 as A</source><translation>Lendo %1 como A</translation></message>
<message><source>the demo</source><translation>a demo</translation></message>
<message><source>Cancelled; what was on the screen stays.</source><translation>Cancelado; o que estava na tela fica.</translation></message>
<message><source>Choose the earlier scan, A; the scan on the screen is the later one, B</source><translation>Escolha a varredura anterior, A; a da tela é a posterior, B</translation></message>
<message><source>A and B are exchanged when both are files: keep a scan as A and open another one.</source><translation>A e B são trocados se ambos são arquivos: mantenha uma varredura como A e abra outra.</translation></message>
<message><source>A was not restored: %1 has changed since.</source><translation>A não foi recuperado: o conteúdo de %1 mudou desde então.</translation></message>
<message><source>Compare with Earlier Scan</source><translation>Comparar com uma varredura anterior</translation></message>
<message><source>Comparing with A</source><translation>Comparando com A</translation></message>
<message><source>Line Up by Surfaces</source><translation>Alinhar pelas superfícies</translation></message>
<message><source>gained, lost and kept</source><translation>ganhas, perdidas e mantidas</translation></message>
<message><source>A and what is on the screen are the same, or are still being compared.</source><translation>A e a tela são iguais, ou ainda estão sendo comparadas.</translation></message>
<message><source>Nothing is kept as A yet: Edges &gt; Compare A/B &gt; Keep This as A.</source><translation>Nada foi guardado ainda como A: Bordas &gt; Comparar A/B &gt; Guardar isto como A.</translation></message>
<message><source>The surfaces of the two scans do not fit, so no areas of change are given.</source><translation>As superfícies das duas varreduras não se ajustam, por isso não se dão áreas de mudança.</translation></message>
<message><source>No surface came nearer or went farther: keep a scan as A and open another one.</source><translation>Nenhuma superfície se aproximou nem se afastou: guarde uma varredura como A e abra outra.</translation></message>
<message><source>region %1 of %2, the largest by area: %3 by %4 m ± %5 m,
now at %7 m; %6 m² at the nearer surface, without its border of one cell</source><translation>região %1 de %2, a maior em área: %3 por %4 m ± %5 m,
agora a %7 m; %6 m² na superfície mais próxima, sem a sua borda de uma célula</translation></message>
<message><source>region %1 of %2: %3 by %4 m ± %5 m,
now at %7 m; %6 m² at the nearer surface, without its border of one cell</source><translation>região %1 de %2: %3 em %4 m ± %5 m,
agora a %7 m; %6 m² na superfície mais próxima, sem a sua borda de uma célula</translation></message>
<message><source>farther</source><translation>mais longe</translation></message>
<message><source>nearer</source><translation>mais perto</translation></message>
<message><source>when the sweep has ended</source><translation>quando a varredura terminar</translation></message>
<message><source>could not be computed:
%1</source><translation>não pôde ser calculada:
%1</translation></message>
<message><source>by confidence</source><translation>por confiança</translation></message>
<message><source>Its strength is %1. An edge reaches the Edge strength %2 at one place, and %3 along the rest.</source><translation>A força é %1. Uma borda atinge a Força da borda %2 em um lugar, e %3 no resto.</translation></message>
<message><source>Its strength %1 is above the Edge strength %2.</source><translation>A sua força %1 está acima da Força da borda %2.</translation></message>
<message><source>Its strength %1 is below the Edge strength %2, but it continues an edge that reaches %3 at line %4, beam %5. Such a cell needs only %6.</source><translation>A sua força %1 está abaixo da Força da borda %2, mas continua uma borda que chega a %3 na linha %4, feixe %5. Para uma célula assim basta %6.</translation></message>
<message><source>This is an edge, but it is left out: only borders of rocks are shown.</source><translation>É uma borda, mas fica de fora: só se mostram contornos de rochas.</translation></message>
<message><source>The surface changes here, but as much or more in the cell next to it, line %1, beam %2: an edge is one cell wide.</source><translation>A superfície muda aqui, mas tanto ou mais na célula vizinha, linha %1, feixe %2: uma borda tem uma célula de largura.</translation></message>
<message><source>In the direction of that cell their strengths are %1 and %2.</source><translation>Na direção dessa célula, as suas forças são %1 e %2.</translation></message>
<message><source>The surface changes too little here to be an edge.</source><translation>A superfície muda pouco demais aqui para ser uma borda.</translation></message>
<message><source>The surface changes here, but no place of this change is strong enough for an edge.</source><translation>A superfície muda aqui, mas nenhum lugar desta mudança basta para uma borda.</translation></message>
<message><source>The surface changes here, but this edge is shorter than the minimum length.</source><translation>A superfície muda aqui, mas esta borda é mais curta que o comprimento mínimo.</translation></message>
<message><source>The surface changes here, but another cell of it is the edge.</source><translation>A superfície muda aqui, mas outra célula dessa mudança é a borda.</translation></message>
<message><source>Nothing was measured here.</source><translation>Nada foi medido aqui.</translation></message>
<message><source>One surface ends here in front of another.</source><translation>Uma superfície termina aqui à frente de outra.</translation></message>
<message><source>The surface bends outwards here, as at the corner of a rock.</source><translation>A superfície dobra para fora aqui, como no canto de uma rocha.</translation></message>
<message><source>The surface bends inwards here, as where two rocks meet.</source><translation>A superfície dobra para dentro aqui, como onde duas rochas se tocam.</translation></message>
<message><source>The measured surface ends here.</source><translation>A superfície medida termina aqui.</translation></message>
<message><source>Edges of this class do not depend on Edge strength.</source><translation>As bordas desta classe não dependem da Força da borda.</translation></message>
<message><source>The surface changes strongly here.</source><translation>A superfície muda muito aqui.</translation></message>
<message><source>The reason could not be found (%1).</source><translation>Não foi possível determinar a razão (%1).</translation></message>
<message><source>&amp;Why is this cell an edge or not?</source><translation>Por &amp;que esta célula é uma borda, ou não?</translation></message>
<message><source>Finding the reason …</source><translation>À procura da razão …</translation></message>
<message><source>under the pointer</source><translation>sob o ponteiro</translation></message>
<message><source>the pinned target, under the pointer</source><translation>o alvo fixado, sob o ponteiro</translation></message>
<message><source>under the pointer, not the pinned target</source><translation>sob o ponteiro, não o alvo fixado</translation></message>
<message><source>the pinned target</source><translation>o alvo fixado</translation></message>
<message><source>the nearest edge</source><translation>a borda mais próxima</translation></message>
<message><source>the near side of your click at %1</source><translation>o lado próximo do seu clique em %1</translation></message>
<message><source>the target that you clicked</source><translation>o alvo em que você clicou</translation></message>
<message><source>the cell that you clicked</source><translation>a célula em que você clicou</translation></message>
<message><source>Cell: %1 (%2)</source><translation>Célula: %1 (%2)</translation></message>
<message><source>Why: click a cell</source><translation>Por quê: clique em uma célula</translation></message>
<message><source>
The strongest cell of its chain is marked in all views; zoomed in, the chain is framed.</source><translation>
A célula mais forte da sua cadeia está marcada em todas as vistas; com zoom, a cadeia aparece emoldurada.</translation></message>
<message><source>Clicked</source><translation>Clique</translation></message>
<message><source>Why</source><translation>Por quê</translation></message>
<message><source>strongest</source><translation>a mais forte</translation></message>
<message><source>the demo after the blast</source><translation>a demonstração após o desmonte</translation></message>
<message><source>%1, scan %2</source><translation>%1, varredura %2</translation></message>
<message><source>the first: the others are placed against it</source><translation>o primeiro: os outros são posicionados em relação a ele</translation></message>
<message><source>OUT OF SPEC, residual %1 mm</source><translation>FORA DE TOLERÂNCIA, resíduo %1 mm</translation></message>
<message><source>registered, residual %1 mm</source><translation>registrado, resíduo %1 mm</translation></message>
<message><source>placed by targets, %1 mm apart</source><translation>posicionado por alvos, afastamento %1 mm</translation></message>
<message><source>placed by pose</source><translation>posicionado pela pose</translation></message>
<message><source>The layer could not be read (%1).</source><translation>Não foi possível ler a camada (%1).</translation></message>
<message><source>Where is the layer now?</source><translation>Onde está a camada agora?</translation></message>
<message><source>This point is of the layer %1: make it active to measure in it.</source><translation>Este ponto é da camada %1: ative-a para medir nela.</translation></message>
<message><source>Make Active</source><translation>Ativar</translation></message>
<message><source>Add scans as layers</source><translation>Adicionar varreduras como camadas</translation></message>
<message><source>Layers are scans of files: open the first one, or record the sweep and open its recording.</source><translation>As camadas são varreduras de arquivos: abra a primeira, ou grave a varredura e abra a gravação.</translation></message>
<message><source>A cloud has at most %1 layers: remove some first.</source><translation>Uma nuvem tem no máximo %1 camadas: remova algumas antes.</translation></message>
<message><source>Add a Layer</source><translation>Adicionar uma camada</translation></message>
<message><source>Remove the Layer</source><translation>Remover a camada</translation></message>
<message><source>Show the Layer</source><translation>Mostrar a camada</translation></message>
<message><source>Hide the Layer</source><translation>Ocultar a camada</translation></message>
<message><source>Locate the Layer</source><translation>Localizar a camada</translation></message>
<message><source>Three places are needed that both scans show: pin them here as targets 1, 2 and 3, make %1 active, pin the same places there in the same order, and come back.</source><translation>São precisos três lugares visíveis nas duas varreduras: marque-os aqui como alvos 1, 2 e 3, ative %1, marque lá os mesmos lugares na mesma ordem e volte.</translation></message>
<message><source>Reading the layer %1</source><translation>Lendo a camada %1</translation></message>
<message><source>Cancelled</source><translation>Cancelado</translation></message>
<message><source>The same scan is a layer already: remove one of the two.</source><translation>A mesma varredura já é uma camada: remova uma das duas.</translation></message>
<message><source>Layer %1: %2</source><translation>Camada %1: %2</translation></message>
<message><source>%1 points · %2 of memory</source><translation>%1 pontos · %2 de memória</translation></message>
<message><source>active</source><translation>ativa</translation></message>
<message><source>▲ active, not placed</source><translation>▲ ativa, não posicionada</translation></message>
<message><source>▲ not placed</source><translation>▲ não posicionada</translation></message>
<message><source>▲ not read</source><translation>▲ não lida</translation></message>
<message><source>being read</source><translation>sendo lida</translation></message>
<message><source>▲ not placed against the active one</source><translation>▲ não posicionada em relação à ativa</translation></message>
<message><source>Target %1: %2 mm apart</source><translation>Alvo %1: a %2 mm</translation></message>
<message><source>sweep %1: %2 lines</source><translation>varredura %1: %2 linhas</translation></message>
<message><source>sweep %1: %2/%3 lines, complete</source><translation>varredura %1: %2/%3 linhas, completa</translation></message>
<message><source>sweep %1: %2/%3 lines, partial</source><translation>varredura %1: %2/%3 linhas, parcial</translation></message>
<message><source>How the stepper turns the scanner is not known.</source><translation>Não se sabe como o motor gira o scanner.</translation></message>
<message><source>How the stepper turns the scanner is not known. Edges are found all the same, but the shape of the cloud is assumed until you give it.</source><translation>Não se sabe como o motor gira o scanner. As bordas são encontradas mesmo assim, mas a forma da nuvem é suposta até que você indique isso.</translation></message>
<message><source>There is no host to connect to: type the scanner's name or address.</source><translation>Não há host ao qual se conectar: digite o nome ou o endereço do scanner.</translation></message>
<message><source>%1 cannot be connected to: type the scanner's name or address, or ws://ROBOT for a robot with ROS.</source><translation>Não é possível ligar a %1: escreva o nome ou o endereço do scanner, ou ws://ROBOT para um robô com ROS.</translation></message>
<message><source>It begins with the sweep under way: %1 lines of it came before Record.</source><translation>Começa com a varredura em curso: %1 linhas dela chegaram antes de Gravar.</translation></message>
<message><source>Give it…</source><translation>Indicá-lo…</translation></message>
<message><source>The first %1 lines of this sweep are too old to be moved to their new places.</source><translation>As primeiras %1 linhas desta varredura são antigas demais para serem movidas ao seu novo lugar.</translation></message>
<message><source>The recording in progress has the old mounting and steps. Correct them with Scan &gt; How the Scan Is Read after you open it, or start another recording.</source><translation>A gravação que está sendo escrita indica a montagem e os passos antigos: corrija-a com Varredura &gt; Como a varredura é lida ao abri-la, ou comece outra.</translation></message>
<message><source>last line %1</source><translation>última linha %1</translation></message>
<message><source>last line %1 at %2 UTC</source><translation>última linha %1 às %2 UTC</translation></message>
<message><source>trying to connect again</source><translation>tentando conectar de novo</translation></message>
<message><source>Waiting for the first line</source><translation>À espera da primeira linha</translation></message>
<message><source>▲ The shape is assumed: give the step in Scan &gt; Sweep…</source><translation>▲ A forma é suposta: indique o passo em Varredura &gt; Varredura…</translation></message>
<message><source>▲ The direction of the cloud is assumed: give the first line in Scan &gt; Sweep…</source><translation>▲ A direção da nuvem é suposta: indique a primeira linha em Varredura &gt; Varredura…</translation></message>
<message><source>▲ The ranges show the mounting: confirm it in Scan &gt; Sweep…</source><translation>▲ As distâncias mostram a montagem: confirme em Varredura &gt; Varredura…</translation></message>
<message><source>▲ The shape is assumed: give mounting and step in Scan &gt; Sweep…</source><translation>▲ A forma é suposta: indique montagem e passo em Varredura &gt; Varredura…</translation></message>
<message><source>Sweep %1 is held on the screen. Follow shows its newest lines.</source><translation>A varredura %1 está retida na tela. Seguir mostra as linhas mais recentes dela.</translation></message>
<message><source>Sweep %1 is held on the screen. Follow shows sweep %2, which grows now.</source><translation>A varredura %1 está retida na tela. Seguir mostra a varredura %2, que cresce agora.</translation></message>
<message><source>Sweep %1 is a part: %2 of %3 lines.</source><translation>A varredura %1 é parcial: %2 de %3 linhas.</translation></message>
<message><source>On the screen: %1</source><translation>Na tela: %1</translation></message>
<message><source>%1 was held with %2 lines when the connection ended.</source><translation>%1 estava retida com %2 linhas quando a conexão terminou.</translation></message>
<message><source>%1 is a part: %2 of %3 lines. The scanner was in the middle of it when EdgeScan connected.</source><translation>%1 é parcial: %2 de %3 linhas. O scanner estava no meio desta varredura quando o EdgeScan se conectou.</translation></message>
<message><source>The next sweep replaces it.</source><translation>A varredura seguinte a substitui.</translation></message>
<message><source>%1 has ended: %2 lines. How many lines a sweep has is not known.</source><translation>%1 terminou: %2 linhas. Não se sabe quantas linhas tem uma varredura.</translation></message>
<message><source>%1 is complete: %2 lines.</source><translation>%1 está completo: %2 linhas.</translation></message>
<message><source>%1 has ended.</source><translation>%1 terminou.</translation></message>
<message><source>Held. Follow shows the next ones, until Hold.</source><translation>Retida. Seguir mostra as seguintes, até Reter.</translation></message>
<message><source>Folder for recordings</source><translation>Pasta das gravações</translation></message>
<message><source>Scan %1</source><translation>Varredura %1</translation></message>
<message><source>Edges and rocks are candidates: geometry only, one viewpoint. What is hidden behind a surface was not measured.</source><translation>As bordas e as rochas são candidatas: só geometria, um ponto de vista. O que está oculto atrás de uma superfície não foi medido.</translation></message>
<message><source>Warnings</source><translation>Avisos</translation></message>
<message><source>None was raised when this file was read.</source><translation>Nenhum ao ler este arquivo.</translation></message>
<message><source>and %1 more in the record.</source><translation>e mais %1 no registro.</translation></message>
<message><source>Remark</source><translation>Observação</translation></message>
<message><source>What, when, by whom</source><translation>O quê, quando, por quem</translation></message>
<message><source>Site</source><translation>Local</translation></message>
<message><source>File</source><translation>Arquivo</translation></message>
<message><source>Format</source><translation>Formato</translation></message>
<message><source>Grid</source><translation>Grade</translation></message>
<message><source>Distances</source><translation>Distâncias</translation></message>
<message><source>%1 to %2 measured; gray levels from %3 to %4</source><translation>medidas de %1 a %2; níveis de cinza de %3 a %4</translation></message>
<message><source>none was measured</source><translation>nenhuma foi medida</translation></message>
<message><source>Scanned</source><translation>Escaneado</translation></message>
<message><source>the file does not say</source><translation>o arquivo não diz</translation></message>
<message><source>%1 (as the pose says)</source><translation>%1 (segundo a pose)</translation></message>
<message><source>Scanner</source><translation>Scanner</translation></message>
<message><source>serial %1</source><translation>número de série %1</translation></message>
<message><source>Uncertainty</source><translation>Incerteza</translation></message>
<message><source>ranges ± %1 m at %2 m, ± %3 m at %4 m (two standard deviations)</source><translation>distâncias ± %1 m a %2 m, ± %3 m a %4 m (dois desvios-padrão)</translation></message>
<message><source>%1; the pose does not say its own</source><translation>%1; a pose não indica a sua</translation></message>
<message><source>Edges</source><translation>Bordas</translation></message>
<message><source>%1 cells, %2 % of those measured</source><translation>%1 células, %2 % das medidas</translation></message>
<message><source>Method</source><translation>Método</translation></message>
<message><source>Report by</source><translation>Relatório de</translation></message>
<message><source>not said</source><translation>não informado</translation></message>
<message><source>Made</source><translation>Feito</translation></message>
<message><source>Where</source><translation>Onde</translation></message>
<message><source>Position</source><translation>Posição</translation></message>
<message><source>not known: no pose</source><translation>desconhecida: sem pose</translation></message>
<message><source>E %1, N %2, RL %3 m (scanner)</source><translation>E %1, N %2, RL %3 m (scanner)</translation></message>
<message><source>Frame</source><translation>Referencial</translation></message>
<message><source>scanner's own frame; no pose was given</source><translation>o do scanner; nenhuma pose foi dada</translation></message>
<message><source>mine grid%1</source><translation>grade da mina%1</translation></message>
<message><source>Robot</source><translation>Robô</translation></message>
<message><source>the pose does not say</source><translation>a pose não diz</translation></message>
<message><source>Pose</source><translation>Pose</translation></message>
<message><source>at a time that it does not say</source><translation>em uma hora que ela não informa</translation></message>
<message><source>%1, the start of the scan is not known</source><translation>%1, o início da varredura não é conhecido</translation></message>
<message><source>%1 s before the start of the scan</source><translation>%1 s antes do início da varredura</translation></message>
<message><source>%1 s after the start of the scan</source><translation>%1 s depois do início da varredura</translation></message>
<message><source>Turning view</source><translation>Vista giratória</translation></message>
<message><source>Drag to turn, wheel or two fingers to come nearer, click a point for its numbers. Keys: arrows turn, + and - come nearer, Shift and arrows shift, Enter picks what is in the middle, Home goes back. Shown, evenly chosen: %1 and %2.</source><translation>Arraste para girar, roda ou dois dedos para aproximar, clique em um ponto para ver seus números. Teclas: as setas giram, + e - aproximam, Shift e setas deslocam, Enter escolhe o que está no meio, Home volta. Mostrados, escolhidos por igual: %1 e %2.</translation></message>
<message><source>Turn</source><translation>Girar</translation></message>
<message><source>Edges only</source><translation>Só bordas</translation></message>
<message><source>Nearer</source><translation>Mais perto</translation></message>
<message><source>Farther</source><translation>Mais longe</translation></message>
<message><source>Larger points</source><translation>Pontos maiores</translation></message>
<message><source>From the start</source><translation>Do início</translation></message>
<message><source>No point there.</source><translation>Não há ponto ali.</translation></message>
<message><source>Line %1, beam %2: range %3 mm, %4; %5 m.</source><translation>Linha %1, feixe %2: distância %3 mm, %4; %5 m.</translation></message>
<message><source>Beam at %1 degrees, line at %2 degrees.</source><translation>Feixe a %1 graus, linha a %2 graus.</translation></message>
<message><source>Rock %1: visible %2 x %3 m, ± %4 m, at %5 m; candidate - geometry only, one viewpoint.</source><translation>Rocha %1: visível %2 x %3 m, ± %4 m, a %5 m; candidata: só geometria, um ponto de vista.</translation></message>
<message><source>This browser has no WebGL; the pictures below show the same.</source><translation>Este navegador não tem WebGL; as imagens abaixo mostram o mesmo.</translation></message>
<message><source>no edge</source><translation>sem borda</translation></message>
<message><source>edge</source><translation>borda</translation></message>
<message><source>jump</source><translation>salto</translation></message>
<message><source>convex fold</source><translation>dobra convexa</translation></message>
<message><source>concave fold</source><translation>dobra côncava</translation></message>
<message><source>data border</source><translation>limite dos dados</translation></message>
<message><source>outline before a void</source><translation>contorno diante de um vazio</translation></message>
<message><source>void rim</source><translation>beira de um vazio</translation></message>
<message><source>Logo</source><translation>Logotipo</translation></message>
<message><source>Size curve of the visible rocks: share of the rocks over their visible width b</source><translation>Curva de tamanhos das rochas visíveis: proporção das rochas pela sua largura visível b</translation></message>
<message><source>Ranges as gray levels, line by line</source><translation>Distâncias como níveis de cinza, linha por linha</translation></message>
<message><source>Edges on darkened gray levels</source><translation>Bordas sobre níveis de cinza escurecidos</translation></message>
<message><source>The points in perspective, seen from behind the scanner</source><translation>Os pontos em perspectiva, vistos de trás do scanner</translation></message>
<message><source>The rocks in perspective, seen from behind the scanner</source><translation>As rochas em perspectiva, vistas de trás do scanner</translation></message>
<message><source>Rocks as coloured faces on gray levels</source><translation>Rochas como faces coloridas sobre níveis de cinza</translation></message>
<message><source>Targets and measures on gray levels</source><translation>Alvos e medidas sobre níveis de cinza</translation></message>
<message><source>What changed, on the grid of this scan</source><translation>O que mudou, na grade desta varredura</translation></message>
<message><source>Points of the scan in three dimensions; arrow keys turn, plus and minus come nearer, Enter picks</source><translation>Pontos da varredura em três dimensões; as setas giram, mais e menos aproximam e afastam, Enter escolhe</translation></message>
<message><source>%1 of %2 points</source><translation>%1 de %2 pontos</translation></message>
<message><source>%1 points</source><translation>%1 pontos</translation></message>
<message><source>%1 of %2 edge cells</source><translation>%1 de %2 células de borda</translation></message>
<message><source>%1 edge cells</source><translation>%1 células de borda</translation></message>
<message><source>Pictures</source><translation>Imagens</translation></message>
<message><source>equal ratios</source><translation>razões iguais</translation></message>
<message><source>Gray levels: black is %1 and nearer, or nothing came back; white is %2 and farther. Across: %3; down: %4.</source><translation>Níveis de cinza: preto é %1 e mais perto, ou nada voltou; branco é %2 e mais longe. Na largura: %3; para baixo: %4.</translation></message>
<message><source>Edges. Across: %1; down: %2.</source><translation>Bordas. Na largura: %1; para baixo: %2.</translation></message>
<message><source>%1 beams, %2 to %3 degrees</source><translation>%1 feixes, %2 a %3 graus</translation></message>
<message><source>%1 lines, %2 to %3 degrees</source><translation>%1 linhas, %2 a %3 graus</translation></message>
<message><source>%1 beams</source><translation>%1 feixes</translation></message>
<message><source>edge (%1)</source><translation>borda (%1)</translation></message>
<message><source>jump (%1)</source><translation>salto (%1)</translation></message>
<message><source>convex fold (%1)</source><translation>dobra convexa (%1)</translation></message>
<message><source>concave fold (%1)</source><translation>dobra côncava (%1)</translation></message>
<message><source>data border (%1)</source><translation>limite dos dados (%1)</translation></message>
<message><source>outline before a void (%1)</source><translation>contorno diante de um vazio (%1)</translation></message>
<message><source>void rim (%1)</source><translation>borda de vazio (%1)</translation></message>
<message><source>%1 of the edge cells are likely the border of a rock (30 % likely and more), %2 are folds within a rock, %3 are unknown.</source><translation>%1 das células de borda são provavelmente o limite de uma rocha (30 % e mais), %2 são dobras dentro de uma rocha, %3 são desconhecidas.</translation></message>
<message><source>%1 m at the middle of the cloud</source><translation>%1 m no meio da nuvem</translation></message>
<message><source>The points, edges in their colours.</source><translation>Os pontos, as bordas em suas cores.</translation></message>
<message><source>Rocks</source><translation>Rochas</translation></message>
<message><source>%1 rocks, each a candidate - geometry only, one viewpoint.</source><translation>%1 rochas, cada uma candidata: só geometria, um ponto de vista.</translation></message>
<message><source>Sizes of the visible rocks</source><translation>Tamanhos das rochas visíveis</translation></message>
<message><source>visible width b [m]</source><translation>largura visível b [m]</translation></message>
<message><source>rocks that are not wider</source><translation>rochas que não são mais largas</translation></message>
<message><source>largest %1</source><translation>maior %1</translation></message>
<message><source>%1 % over %2</source><translation>%1 % acima de %2</translation></message>
<message><source>The rocks with the largest visible width b</source><translation>As rochas de maior largura visível b</translation></message>
<message><source>On a narrow screen only the rocks of the table have their numbers.</source><translation>Em uma tela estreita só as rochas da tabela têm seus números.</translation></message>
<message><source>Completeness</source><translation>Completude</translation></message>
<message><source>INCOMPLETE</source><translation>INCOMPLETO</translation></message>
<message><source>%1 of %2 lines, %3 cells.</source><translation>%1 de %2 linhas, %3 células.</translation></message>
<message><source>measured</source><translation>medidas</translation></message>
<message><source>status of the scanner</source><translation>estado do scanner</translation></message>
<message><source>outside the range window</source><translation>fora da janela de distâncias</translation></message>
<message><source>lost line</source><translation>linha perdida</translation></message>
<message><source>Settings</source><translation>Ajustes</translation></message>
<message><source>File and program</source><translation>Arquivo e programa</translation></message>
<message><source>auto: %1</source><translation>auto: %1</translation></message>
<message><source>%1 cells</source><translation>%1 células</translation></message>
<message><source>%1 steps</source><translation>%1 passos</translation></message>
<message><source>%1 % of range</source><translation>%1 % da distância</translation></message>
<message><source>%1 % of high</source><translation>%1 % do alto</translation></message>
<message><source>changed from the default</source><translation>diferente do valor usual</translation></message>
<message><source>The command that makes this report as a page for browsers</source><translation>O comando que faz este relatório como página para navegadores</translation></message>
<message><source>SHA-256 of the file</source><translation>SHA-256 do arquivo</translation></message>
<message><source>SHA-256 of the grid</source><translation>SHA-256 da grade</translation></message>
<message><source>SHA-256 of the edge mask</source><translation>SHA-256 da máscara de bordas</translation></message>
<message><source>none</source><translation>nenhuma</translation></message>
<message><source>Program</source><translation>Programa</translation></message>
<message><source>EdgeScan %1, commit %2</source><translation>EdgeScan %1, commit %2</translation></message>
<message><source>The whole record</source><translation>O registro completo</translation></message>
<message><source>Targets and measures</source><translation>Alvos e medidas</translation></message>
<message><source>Target</source><translation>Alvo</translation></message>
<message><source>Name and note</source><translation>Nome e nota</translation></message>
<message><source>Cell</source><translation>Célula</translation></message>
<message><source>Where, and its edge now</source><translation>Onde, e sua borda agora</translation></message>
<message><source>Also on its card when it was pinned</source><translation>Também em sua ficha quando foi fixado</translation></message>
<message><source>Pinned</source><translation>Fixado</translation></message>
<message><source>Measured</source><translation>Medições</translation></message>
<message><source>Result, ± two standard deviations</source><translation>Resultado, ± dois desvios-padrão</translation></message>
<message><source>From</source><translation>De</translation></message>
<message><source>no cell of this scan</source><translation>não é uma célula desta varredura</translation></message>
<message><source>its cells hold no points now</source><translation>suas células não têm pontos agora</translation></message>
<message><source>M%1 %2</source><translation>M%1 %2</translation></message>
<message><source>E, N, RL: %1</source><translation>E, N, RL: %1</translation></message>
<message><source>Distance: %1</source><translation>Distância: %1</translation></message>
<message><source>Dip / direction: %1</source><translation>Mergulho / direção: %1</translation></message>
<message><source>Edge: %1</source><translation>Borda: %1</translation></message>
<message><source>Resolves: %1</source><translation>Resolução: %1</translation></message>
<message><source>Surface: %1</source><translation>Superfície: %1</translation></message>
<message><source>From the boom: %1</source><translation>Ao braço: %1</translation></message>
<message><source>Confidence: %1</source><translation>Confiança: %1</translation></message>
<message><source>%1° ± %2° off the beam</source><translation>a %1° ± %2° do feixe</translation></message>
<message><source>%1 · surface %2° off square</source><translation>%1 · superfície a %2° da perpendicular</translation></message>
<message><source>%1 % of %2 settings</source><translation>%1 % de %2 ajustes</translation></message>
<message><source>raw grid</source><translation>grade bruta</translation></message>
<message><source>%1, strength %2</source><translation>%1, força %2</translation></message>
<message><source>no plane fits</source><translation>nenhum plano se ajusta</translation></message>
<message><source>▲ no pose</source><translation>▲ sem pose</translation></message>
<message><source>nothing was measured in this cell</source><translation>nada foi medido nesta célula</translation></message>
<message><source>Before and after</source><translation>Antes e depois</translation></message>
<message><source>▲ OUT OF SPEC: the warnings below say why.</source><translation>▲ FORA DE TOLERÂNCIA: os avisos abaixo dizem por quê.</translation></message>
<message><source>Before: %1. Surfaces and edges that this scan shows otherwise; what is hidden in one of the two is not a change.</source><translation>Antes: %1. Superfícies e bordas que esta varredura mostra de outro modo; o que está oculto em uma das duas não é uma mudança.</translation></message>
<message><source>+ edge gained, or surface nearer</source><translation>+ borda ganha, ou superfície mais perto</translation></message>
<message><source>− edge lost, or surface farther</source><translation>− borda perdida, ou superfície mais longe</translation></message>
<message><source>= edge kept</source><translation>= borda mantida</translation></message>
<message><source>%1 has an uncertain outline (hatched); %2 pieces are too small to be shown as rocks</source><translation>%1 tem um contorno incerto (hachurado); %2 peças são pequenas demais para serem mostradas como rochas</translation></message>
<message><source>%1 have an uncertain outline (hatched); %2 pieces are too small to be shown as rocks</source><translation>%1 têm um contorno incerto (hachurado); %2 peças são pequenas demais para serem mostradas como rochas</translation></message>
<message><source>, %1 are outside the region of interest</source><translation>, %1 estão fora da região de interesse</translation></message>
<message><source>; %1 change was made by hand</source><translation>; %1 mudança foi feita à mão</translation></message>
<message><source>; %1 changes were made by hand</source><translation>; %1 mudanças foram feitas à mão</translation></message>
<message><source>Level %1 of -4 (fine) to 4 (coarse).</source><translation>Nível %1 de -4 (fino) a 4 (grosso).</translation></message>
<message><source>Visible width b: P20 %1 m, P50 %2 m, P80 %3 m (20, 50 and 80 % of the rocks are not wider), largest %4 m</source><translation>Largura visível b: P20 %1 m, P50 %2 m, P80 %3 m (20, 50 e 80 % das rochas não são mais largas), maior %4 m</translation></message>
<message><source>; %1 % over the site's %2 m</source><translation>; %1 % acima dos %2 m do local</translation></message>
<message><source>by number of visible rocks; hidden parts make it finer than the pile is, by 40 % and more</source><translation>por número de rochas visíveis; pelas partes ocultas é mais fina que a pilha, em 40 % e mais</translation></message>
<message><source>Rocks as faces, uncertain ones hatched. Colours only separate neighbours. The numbers are those of the table, the drawing and the files.</source><translation>Rochas como faces, as incertas hachuradas. As cores só separam vizinhas. Os números são os da tabela, do desenho e dos arquivos.</translation></message>
<message><source>The rocks on the points.</source><translation>As rochas sobre os pontos.</translation></message>
<message><source>%1 numbers of smaller rocks have no room and are left out.</source><translation>%1 números de rochas menores não cabem e faltam.</translation></message>
<message><source>The %1 largest (visible width b) of %2 rocks; the export of rocks as a table lists all.</source><translation>As %1 maiores (largura visível b) de %2 rochas; a exportação das rochas como tabela tem todas.</translation></message>
<message><source>The %1 largest (visible width b) of %2 rocks; %3 more are over the site's %4; the export of rocks as a table lists all.</source><translation>As %1 maiores (largura visível b) de %2 rochas; outras %3 passam dos %4 do local; a exportação das rochas como tabela tem todas.</translation></message>
<message><source>E, N, RL: mean of the visible points, in the mine grid</source><translation>E, N, RL: média dos pontos visíveis, na grade da mina</translation></message>
<message><source>x, y, z: mean of the visible points, in the scanner's frame.</source><translation>x, y, z: média dos pontos visíveis, no referencial do scanner.</translation></message>
<message><source>a and b: visible spans across the line of sight; hidden parts are not counted. Distance: median of its ranges. Area: visible, across the beams. In front: share of the outline where the rock is the nearer side. Contacts and free height: at least. Arch: largest angle at the rock between two that it touches; ↓ it hangs below the line between them. p: chance that the outline is right; ▲ below 0.85, hatched.</source><translation>a e b: extensões visíveis transversais à linha de visada; as partes ocultas não contam. Distância: mediana de suas distâncias. Área: visível, transversal aos feixes. Na frente: parte do contorno onde a rocha é o lado mais próximo. Contatos e altura livre: no mínimo. Arco: maior ângulo na rocha entre duas que ela toca; ↓ ela pende abaixo da linha entre elas. p: chance de o contorno estar certo; ▲ menor que 0.85, hachurado.</translation></message>
<message><source>Without a pose, up is the scanner's z axis, which is assumed: free height and ↓ are measured along it.</source><translation>Sem pose, para cima é o eixo z do scanner, que é suposto: a altura livre e ↓ são medidos ao longo dele.</translation></message>
<message><source>Number with ▲: merged by hand of parts that do not touch.</source><translation>Número com ▲: unida à mão de partes que não se tocam.</translation></message>
<message><source>The targets by their numbers, and what was measured. Black is near, or nothing came back.</source><translation>Os alvos por seus números, e o que foi medido. Preto é perto, ou nada voltou.</translation></message>
<message><source>%1 value has no room in the picture; the table has all.</source><translation>%1 valor não cabe na imagem; a tabela tem todos.</translation></message>
<message><source>%1 values have no room in the picture; the table has all.</source><translation>%1 valores não cabem na imagem; a tabela tem todos.</translation></message>
<message><source>; other cells: points of one moved to the grid of the other</source><translation>; outras células: pontos de uma levados à grade da outra</translation></message>
<message><source>edges: %1 + gained, %2 - lost, %3 kept, %4 not seen by the other</source><translation>bordas: %1 + ganhas, %2 - perdidas, %3 mantidas, %4 não vistas pela outra</translation></message>
<message><source>cells: %1 nearer, %2 farther, %3 same, %4 no range now, %5 no range before</source><translation>células: %1 mais perto, %2 mais longe, %3 iguais, %4 sem distância agora, %5 sem distância antes</translation></message>
<message><source>median difference</source><translation>diferença mediana</translation></message>
<message><source>a change is more than %1 standard deviations: %2 mm at 5 m, %3 mm at 10 m</source><translation>uma mudança é mais de %1 desvios-padrão: %2 mm a 5 m, %3 mm a 10 m</translation></message>
<message><source>%1 regions of %2 cells and more, visible surface from one viewpoint</source><translation>%1 regiões de %2 células e mais, superfície visível de um ponto de vista</translation></message>
<message><source>View %1 is stored.</source><translation>A vista %1 está salva.</translation></message>
<message><source>There is no view %1 yet: Ctrl+%1 stores the present one.</source><translation>Ainda não há vista %1: Ctrl+%1 salva a atual.</translation></message>
<message><source>There is nothing to report yet: open a scan first.</source><translation>Ainda não há nada para relatar: primeiro abra uma varredura.</translation></message>
<message><source>Report</source><translation>Relatório</translation></message>
<message><source>Page for any browser (*.html)</source><translation>Página para qualquer navegador (*.html)</translation></message>
<message><source>PDF (*.pdf)</source><translation>PDF (*.pdf)</translation></message>
<message><source>Making the report %1</source><translation>Criando o relatório %1</translation></message>
<message><source>pages to print</source><translation>páginas para imprimir</translation></message>
<message><source>a page for any browser</source><translation>uma página para qualquer navegador</translation></message>
<message><source>The report could not be made (%1).</source><translation>Não foi possível fazer o relatório (%1).</translation></message>
<message><source>RL [m]</source><translation>RL [m]</translation></message>
<message><source>above the scanner [m]</source><translation>acima do scanner [m]</translation></message>
<message><source>The section could not be computed (%1).</source><translation>Não foi possível calcular a secção (%1).</translation></message>
<message><source>Se&amp;ction</source><translation>Se&amp;cção</translation></message>
<message><source>Measure a distance first: a section goes through its two ends.</source><translation>Meça primeiro uma distância: a secção passa pelas suas duas extremidades.</translation></message>
<message><source>Select a rock first: show the rocks and click on the face of one.</source><translation>Selecione primeiro uma rocha: mostre as rochas e clique na face de uma.</translation></message>
<message><source>The plane of the section meets no surface: choose two other cells.</source><translation>O plano da secção não encontra nenhuma superfície: escolha outras duas células.</translation></message>
<message><source>Vertical plane, true scale; dash-dotted in the views.</source><translation>Plano vertical, escala real; traço-ponto nas vistas.</translation></message>
<message><source>Rocks have their colours.</source><translation>As rochas têm suas cores.</translation></message>
<message><source>▲ no pose: up is the scanner's z</source><translation>▲ sem pose: para cima é o z do scanner</translation></message>
<message><source>The rocks are still being computed: export the section again in a moment.</source><translation>As rochas ainda estão sendo calculadas: exporte de novo a seção em um momento.</translation></message>
<message><source>Export Section</source><translation>Exportar a secção</translation></message>
<message><source>Drawing (*.dxf)</source><translation>Desenho (*.dxf)</translation></message>
<message><source>Table (*.csv)</source><translation>Tabela (*.csv)</translation></message>
<message><source>Picture (*.png)</source><translation>Imagem (*.png)</translation></message>
<message><source>class %1 on</source><translation>classe %1 ativada</translation></message>
<message><source>class %1 off</source><translation>classe %1 desativada</translation></message>
<message><source>%1 %2 to %3</source><translation>%1 de %2 a %3</translation></message>
<message><source>settings</source><translation>ajustes</translation></message>
<message><source>This scan is flat and quiet: with the preset Smooth walls low steps far away are edges too.</source><translation>Esta varredura é plana e com pouco ruído: com a predefinição Paredes lisas os degraus baixos distantes também são bordas.</translation></message>
<message><source>Use It</source><translation>Usar</translation></message>
<message><source>Open preset</source><translation>Abrir uma predefinição</translation></message>
<message><source>EdgeScan presets (*.json)</source><translation>Predefinições do EdgeScan (*.json)</translation></message>
<message><source>Save preset</source><translation>Salvar a predefinição</translation></message>
<message><source>%1 is not a preset and stays as it is: choose another name.</source><translation>%1 não é uma predefinição e fica como está: escolha outro nome.</translation></message>
<message><source>a section</source><translation>uma secção</translation></message>
<message><source>a section of %1</source><translation>uma secção de %1</translation></message>
<message><source>%1 edge points</source><translation>%1 pontos de borda</translation></message>
<message><source>Nothing is selected yet: drag a box (B) or a lasso (L) over a view first.</source><translation>Ainda não há nada selecionado: primeiro trace uma caixa (B) ou um laço (L) sobre uma vista.</translation></message>
<message><source>There is nothing to export yet: open a scan first.</source><translation>Ainda não há nada para exportar: primeiro abra uma varredura.</translation></message>
<message><source>Export %1 points</source><translation>Exportar %1 pontos</translation></message>
<message><source>Export targets: %1</source><translation>Exportar alvos: %1</translation></message>
<message><source>Export</source><translation>Exportar</translation></message>
<message><source>Save screenshot</source><translation>Salvar a captura de tela</translation></message>
<message><source>PNG picture (*.png)</source><translation>Imagem PNG (*.png)</translation></message>
<message><source>a picture of the window</source><translation>uma imagem da janela</translation></message>
<message><source>There is no file on the screen that could be read in another way: open one first.</source><translation>Não há na tela nenhum arquivo que possa ser lido de outra maneira: primeiro abra um.</translation></message>
<message><source>All supported (%1)</source><translation>Todos os formatos aceitos (%1)</translation></message>
<message><source>All files (*)</source><translation>Todos os arquivos (*)</translation></message>
<message><source>Open scan</source><translation>Abrir uma varredura</translation></message>
<message><source>This is the last scan of the series or folder.</source><translation>Esta é a última varredura da série ou da pasta.</translation></message>
<message><source>This is the first scan of the series or folder.</source><translation>Esta é a primeira varredura da série ou da pasta.</translation></message>
<message><source>Straighten Beams</source><translation>Endireitar os feixes</translation></message>
<message><source>Beams as Recorded</source><translation>Feixes como gravados</translation></message>
<message><source>Keep Repeated Values</source><translation>Manter os valores repetidos</translation></message>
<message><source>Repeated Values as No Return</source><translation>Valores repetidos como sem retorno</translation></message>
<message><source>Read it in another way…</source><translation>Ler de outra maneira…</translation></message>
<message><source>How the Scan Is Read</source><translation>Como a varredura é lida</translation></message>
<message><source>%1 was moved or removed. Its picture stays on the screen.</source><translation>%1 foi movido ou removido. Sua imagem fica na tela.</translation></message>
<message><source>%1 was written again. The picture shows what was in it before.</source><translation>%1 foi gravado de novo. A imagem mostra o que havia nele antes.</translation></message>
<message><source>Read again</source><translation>Ler de novo</translation></message>
<message><source>%1, a pose of 3DTK, is not read with the scan: type the place of the scanner at Scan &gt; Pose and Mounting.</source><translation>%1, uma pose de 3DTK, não é lida com a varredura: digite o lugar do scanner em Varredura &gt; Pose e montagem.</translation></message>
<message><source>Straighten beams</source><translation>Endireitar os feixes</translation></message>
<message><source>Keep as measured</source><translation>Manter como medido</translation></message>
<message><source>No file yet; demos are not listed</source><translation>Nenhum arquivo ainda; as demos não constam aqui</translation></message>
<message><source>Clear</source><translation>Limpar</translation></message>
<message><source> (%1 of %2)</source><translation> (%1 de %2)</translation></message>
<message><source>Does this look right?</source><translation>Parece correto?</translation></message>
<message><source>On the screen, not yet adopted: %1</source><translation>Na tela, ainda não adotado: %1</translation></message>
<message><source>The scanner looks forward: what is above it without a pose is now in front of it. If it looks up into a bell, choose “up” on the page Mounting.</source><translation>O scanner olha para a frente: o que sem pose está acima dele está agora à sua frente. Se ele olha para cima para dentro de um sino, escolha “para cima” na página Montagem.</translation></message>
<message><source>The mounting looks up, but pitch and roll turn it to the side: type 0 and 0 for a level boom, or choose “forward” on the page Mounting.</source><translation>A montagem olha para cima, mas arfagem e rolagem viram-na para o lado: digite 0 e 0 para um braço nivelado, ou escolha “para a frente” na página Montagem.</translation></message>
<message><source>The mounting looks up, but %1 % of the points are lower than the scanner: correct pitch and roll, or choose another direction on the page Mounting.</source><translation>A montagem olha para cima, mas %1 % dos pontos estão mais baixos do que o scanner: corrija arfagem e rolagem, ou escolha outra direção na página Montagem.</translation></message>
<message><source>Scanner at E %1, N %2, RL %3 m. </source><translation>Scanner em E %1, N %2, RL %3 m. </translation></message>
<message><source>It looks %1° below the horizon. </source><translation>Olha %1° abaixo do horizonte. </translation></message>
<message><source>It looks %1° above the horizon. </source><translation>Olha %1° acima do horizonte. </translation></message>
<message><source>Its points: </source><translation>Seus pontos: </translation></message>
<message><source>It failed (%1); close other programs or use a smaller scan.</source><translation>Falhou (%1); feche outros programas ou use uma varredura menor.</translation></message>
<message><source>Store Pose</source><translation>Guardar a pose</translation></message>
<message><source>Remove Pose</source><translation>Remover a pose</translation></message>
<message><source>Open a scan first.</source><translation>Abra primeiro uma varredura.</translation></message>
<message><source>The picture does not come from a file, so its pose cannot be stored: open a scan or a recording.</source><translation>A imagem não vem de um arquivo, por isso a pose não pode ser guardada: abra uma varredura ou uma gravação.</translation></message>
<message><source>Store the mounting</source><translation>Guardar a montagem</translation></message>
<message><source>Name of the scanner</source><translation>Nome do scanner</translation></message>
<message><source>The robot's calibration</source><translation>A calibração do robô</translation></message>
<message><source>Calibration (*.json)</source><translation>Calibração (*.json)</translation></message>
<message><source>The pose that was stored with the scan is removed.</source><translation>A pose guardada com a varredura foi removida.</translation></message>
<message><source>The pose is stored with the scan, in %1; it replaced the one that was there.</source><translation>A pose foi guardada com a varredura, em %1; substituiu a que havia.</translation></message>
<message><source>The pose is stored with the scan, in %1.</source><translation>A pose foi guardada com a varredura, em %1.</translation></message>
<message><source>The pose could not be stored (%1).</source><translation>A pose não pôde ser guardada (%1).</translation></message>
<message><source>, %1 min ago</source><translation>, há %1 min</translation></message>
<message><source>, %1 h ago</source><translation>, há %1 h</translation></message>
<message><source>, %1 days ago</source><translation>, há %1 dias</translation></message>
<message><source>Placed by %1</source><translation>Posicionado por %1</translation></message>
<message><source>HELD, %1 of %2 lines</source><translation>RETIDO, %1 de %2 linhas</translation></message>
<message><source>HELD, whole sweep</source><translation>RETIDO, varredura inteira</translation></message>
<message><source>HELD, sweep %1 grows</source><translation>RETIDO, a varredura %1 cresce</translation></message>
<message><source>HELD</source><translation>RETIDO</translation></message>
<message><source>HELD, 1 line behind</source><translation>RETIDO, 1 linha atrás</translation></message>
<message><source>HELD, %1 lines behind</source><translation>RETIDO, %1 linhas atrás</translation></message>
<message><source> · no time</source><translation> · sem hora</translation></message>
<message><source>What the scanner sends now, with the time of its newest line. %1</source><translation>O que o scanner envia agora, com a hora da sua linha mais recente. %1</translation></message>
<message><source>The connection to the scanner has ended: the time is that of the newest line</source><translation>O scanner já não está conectado: a hora é a da linha mais recente</translation></message>
<message><source>The scanner goes on, this picture does not: the time is that of its newest line</source><translation>O scanner continua, esta imagem não: a hora é a da sua linha mais recente</translation></message>
<message><source>NO PICTURE</source><translation>SEM IMAGEM</translation></message>
<message><source>RECORDED</source><translation>GRAVADO</translation></message>
<message><source>Last line, by %1</source><translation>Última linha, segundo %1</translation></message>
<message><source>FILE</source><translation>ARQUIVO</translation></message>
<message><source>no time</source><translation>sem hora</translation></message>
<message><source>The file does not say when it was measured</source><translation>O arquivo não diz quando foi medido</translation></message>
<message><source>First line, by %1</source><translation>Primeira linha, segundo %1</translation></message>
<message><source>COARSE PICTURE</source><translation>IMAGEM GROSSEIRA</translation></message>
<message><source>Some points of the scan that is being opened.</source><translation>Alguns pontos da varredura que está sendo aberta.</translation></message>
<message><source>OLD PICTURE</source><translation>IMAGEM ANTERIOR</translation></message>
<message><source>Another scan is being opened. This is the picture before it.</source><translation>Outra varredura está sendo aberta. Esta é a imagem anterior.</translation></message>
<message><source>%1 Edits of rocks are not stored until then.</source><translation>%1 Até lá as edições das rochas não são guardadas.</translation></message>
<message><source>Edits of rocks are not stored: %1</source><translation>As edições das rochas não são guardadas: %1</translation></message>
<message><source>Split: click the part that is a rock of its own (wheel: smaller or larger)</source><translation>Dividir: clique na parte que é outra rocha (roda: menor ou maior)</translation></message>
<message><source>Merge: drag a line across the rocks, or click the one that belongs to the selected rock</source><translation>Mesclar: trace uma linha sobre as rochas, ou clique na que pertence à rocha selecionada</translation></message>
<message><source>Cut: drag a line through the rock, or click both its ends</source><translation>Cortar: trace uma linha através da rocha, ou clique nas suas duas pontas</translation></message>
<message><source>Region: drag a line around it</source><translation>Região: trace uma linha em volta</translation></message>
<message><source>the whole piece as it is</source><translation>o pedaço inteiro como está</translation></message>
<message><source>a click splits it off</source><translation>um clique o separa</translation></message>
<message><source>larger than the rock: a click merges it</source><translation>maior que a rocha: um clique o mescla</translation></message>
<message><source>no smaller and no larger part</source><translation>não há parte menor nem maior</translation></message>
<message><source>wheel: larger (this is the smallest part)</source><translation>roda: maior (esta é a menor parte)</translation></message>
<message><source>wheel: smaller (this is the largest piece)</source><translation>roda: menor (esta é a maior peça)</translation></message>
<message><source>wheel: smaller or larger</source><translation>roda: menor ou maior</translation></message>
<message><source>%1 cells, %2</source><translation>%1 células, %2</translation></message>
<message><source>Nothing was split: click on a rock, on the part that is a rock of its own.</source><translation>Nada foi dividido: clique em uma rocha, na parte que é uma rocha à parte.</translation></message>
<message><source>The rocks are still being computed: split again when they are here.</source><translation>As rochas ainda estão sendo calculadas: divida de novo quando estiverem aqui.</translation></message>
<message><source>split of a rock</source><translation>divisão de uma rocha</translation></message>
<message><source>Nothing was split: this rock is one piece without a line that separates parts. Cut along a Line splits it where you draw.</source><translation>Nada foi dividido: esta rocha é um só pedaço e nada distingue as suas partes. Cortar ao longo de uma linha divide-a onde você desenhar.</translation></message>
<message><source>merge of rocks</source><translation>mesclagem de rochas</translation></message>
<message><source>Click the other end of the line, past the other side of the rock.</source><translation>Clique na outra ponta da linha, além do outro lado da rocha.</translation></message>
<message><source>cut of a rock</source><translation>corte de uma rocha</translation></message>
<message><source>Nothing was cut: draw the line through a rock, from one side to the other. Each part needs %1 cells.</source><translation>Nada foi cortado: trace a linha através de uma rocha, de um lado ao outro. Cada parte precisa de %1 células.</translation></message>
<message><source>Nothing was merged: draw the line from one rock over the crack into the next.</source><translation>Nada foi mesclado: trace a linha de uma rocha até a seguinte, por cima da fenda.</translation></message>
<message><source>There is no region yet: draw the line round what counts, in one of the images.</source><translation>Ainda não há região: trace a linha em volta do que conta, em uma das imagens.</translation></message>
<message><source>region of interest</source><translation>região de interesse</translation></message>
<message><source>Open Session</source><translation>Abrir a sessão</translation></message>
<message><source>The session's edits of rocks replaced those that were stored next to the scan; Ctrl+Z brings them back.</source><translation>As correções de rochas da sessão substituíram as guardadas ao lado da varredura; Ctrl+Z as traz de volta.</translation></message>
<message><source>No rock changed, so nothing is to be undone. Click on another part of the rock, or draw across the whole of it, past its outline.</source><translation>Nenhuma rocha mudou, portanto não há nada a desfazer. Clique em outra parte da rocha, ou desenhe através de toda ela, além do seu contorno.</translation></message>
<message><source>Nothing was merged: this is one rock already.</source><translation>Nada foi unido: já é uma só rocha.</translation></message>
<message><source>mark as a rock</source><translation>marca de rocha</translation></message>
<message><source>mark as not a rock</source><translation>marca de não rocha</translation></message>
<message><source>There is nothing to export yet: show the rocks of a scan first.</source><translation>Ainda não há nada para exportar: primeiro mostre as rochas de uma varredura.</translation></message>
<message><source>Export %1 of %2</source><translation>Exportar %1 de %2</translation></message>
<message><source>Export %1</source><translation>Exportar %1</translation></message>
<message><source>%1 was not written: give it one of the endings %2.</source><translation>%1 não foi escrito: dê a ele uma das extensões %2.</translation></message>
<message><source>%1 waits for the rocks</source><translation>%1 espera as rochas</translation></message>
<message><source>%1 was not written: its rocks are not known.</source><translation>%1 não foi gravado: as suas rochas não são conhecidas.</translation></message>
<message><source>the rock could not be cut (%1); close other programs.</source><translation>não foi possível cortar a rocha (%1); feche outros programas.</translation></message>
<message><source>the rocks could not be computed (%1); close other programs or open a smaller scan.</source><translation>não foi possível calcular as rochas (%1); feche outros programas ou abra uma varredura menor.</translation></message>
<message><source>Another window changed the rocks of this scan. The changes of both windows are kept.</source><translation>Outra janela alterou as rochas desta varredura. As alterações das duas janelas são mantidas.</translation></message>
<message><source>▲ of the first %1 lines</source><translation>▲ das primeiras %1 linhas</translation></message>
<message><source>▲ of the picture before; being computed again</source><translation>▲ da imagem anterior; em novo cálculo</translation></message>
<message><source>being computed …</source><translation>em cálculo …</translation></message>
<message><source>No rock was found here: choose Pin to set a target.</source><translation>Nenhuma rocha aqui: escolha Fixar para marcar um alvo.</translation></message>
<message><source>This Is a Roc&amp;k</source><translation>Isto é uma &amp;rocha</translation></message>
<message><source>&amp;Rock %1</source><translation>&amp;Rocha %1</translation></message>
<message><source>Se&amp;lect</source><translation>Se&amp;lecionar</translation></message>
<message><source>&amp;Merge with Selected Rocks</source><translation>&amp;Unir às rochas selecionadas</translation></message>
<message><source>&amp;Split Here</source><translation>&amp;Dividir aqui</translation></message>
<message><source>&amp;Cut along a Line</source><translation>&amp;Cortar ao longo de uma linha</translation></message>
<message><source>&amp;Wall, Not a Rock</source><translation>&amp;Parede, não é uma rocha</translation></message>
<message><source>&amp;Export Rocks…</source><translation>&amp;Exportar as rochas…</translation></message>
<message><source>Rock %1 has the largest visible width b, %2 m. Rock 1 has the largest visible area.</source><translation>A rocha %1 tem a maior largura visível b, %2 m. A rocha 1 tem a maior área visível.</translation></message>
<message><source>No rock has a smaller visible width b.</source><translation>Nenhuma rocha tem uma largura visível b menor.</translation></message>
<message><source>EdgeScan sessions (*%1)</source><translation>Sessões do EdgeScan (*%1)</translation></message>
<message><source>JSON files (*.json)</source><translation>Arquivos JSON (*.json)</translation></message>
<message><source>The session is not saved (%1).</source><translation>A sessão não é salva (%1).</translation></message>
<message><source>The session is not saved: %1</source><translation>A sessão não é salva: %1</translation></message>
<message><source>from now on saved as it changes</source><translation>a partir de agora salva a cada mudança</translation></message>
<message><source>There is nothing to save yet: open a scan first. To store a live sweep, record it.</source><translation>Ainda não há nada a salvar: abra primeiro uma varredura. Uma varredura ao vivo guarda-se gravando-a.</translation></message>
<message><source>Save session</source><translation>Salvar sessão</translation></message>
<message><source>%1 is not a session and stays as it is: choose another name.</source><translation>%1 não é uma sessão e fica como está: escolha outro nome.</translation></message>
<message><source>Open session</source><translation>Abrir sessão</translation></message>
<message><source>Screenshots (*.png)</source><translation>Capturas de tela (*.png)</translation></message>
<message><source>%1: this is not a session; choose a session, or a screenshot that carries one.</source><translation>%1: isto não é uma sessão; escolha uma sessão, ou uma captura de tela que traga uma.</translation></message>
<message><source>%1: the scan of this session was not found. It was moved, or its disk is missing. Settings and view are restored. The rest needs the scan.</source><translation>%1: a varredura desta sessão não foi encontrada. Foi movida, ou falta o disco. Ajustes e vista foram restaurados. O resto precisa da varredura.</translation></message>
<message><source>Locate…</source><translation>Localizar…</translation></message>
<message><source>Where is the scan now?</source><translation>Onde está a varredura agora?</translation></message>
<message><source>The session %1 is not changed: this is another scan.</source><translation>A sessão %1 não é alterada: esta é outra varredura.</translation></message>
<message><source>%1 is not the scan of this session: its content differs. Settings and view are restored; targets, selection, marks, rocks, A and the camera are not.</source><translation>%1 não é a varredura desta sessão: o conteúdo é outro. Ajustes e vista foram restaurados; alvos, seleção, marcas, rochas, A e a câmera não.</translation></message>
<message><source>measurements: %1</source><translation>medições: %1</translation></message>
<message><source>edits of rocks: %1</source><translation>correções de rochas: %1</translation></message>
<message><source>settings, view</source><translation>ajustes, vista</translation></message>
<message><source>Restored: %1. Undo begins here.</source><translation>Restaurado: %1. Desfazer começa aqui.</translation></message>
<message><source>There is no session to go on with yet: open a scan first.</source><translation>Ainda não há sessão a continuar: abra primeiro uma varredura.</translation></message>
<message><source>EdgeScan ended without being closed. What was on the screen at %1 is stored.</source><translation>O EdgeScan terminou sem ser fechado. O que estava na tela em %1 foi guardado.</translation></message>
<message><source>Go on where I was</source><translation>Continuar onde estava</translation></message>
<message><source>Nothing could be proposed (%1).</source><translation>Não foi possível propor nada (%1).</translation></message>
<message><source>This &amp;is an edge</source><translation>Isto &amp;é uma borda</translation></message>
<message><source>This is &amp;not an edge</source><translation>Isto &amp;não é uma borda</translation></message>
<message><source>Point at a cell or click one first; then say whether an edge is there.</source><translation>Aponte ou clique primeiro em uma célula; depois diga se há uma borda.</translation></message>
<message><source>This cell was not marked: there are %1 marks, clear some first.</source><translation>Esta célula não foi marcada: já há %1 marcas, apague algumas primeiro.</translation></message>
<message><source>Mark as an Edge</source><translation>Marca de borda</translation></message>
<message><source>Mark as Not an Edge</source><translation>Marca de não borda</translation></message>
<message><source>the mark “edge” at line %1, beam %2</source><translation>a marca “borda” na linha %1, feixe %2</translation></message>
<message><source>the mark “not an edge” at line %1, beam %2</source><translation>a marca “sem borda” na linha %1, feixe %2</translation></message>
<message><source>Clear the Marks</source><translation>Apagar as marcas</translation></message>
<message><source>all marks, %1 “edge” and %2 “not an edge”</source><translation>todas as marcas, %1 “borda” e %2 “sem borda”</translation></message>
<message><source>✓ edge</source><translation>✓ borda</translation></message>
<message><source>✕ not an edge</source><translation>✕ sem borda</translation></message>
<message><source>Nothing is marked yet: right-click a cell and mark it as an edge, or as not an edge.</source><translation>Nada está marcado ainda: clique com o botão direito em uma célula e marque-a como borda ou como não borda.</translation></message>
<message><source>The sweep is still growing: wait for its end, or hold it.</source><translation>A varredura ainda cresce: espere o fim, ou congele-a.</translation></message>
<message><source>Finding settings for these marks: method %1 of %2 …</source><translation>Procurando ajustes para estas marcas: método %1 de %2 …</translation></message>
<message><source>Settings for These Marks</source><translation>Ajustes para estas marcas</translation></message>
<message><source>%1 of %2 methods agree with all marks.</source><translation>%1 de %2 métodos concordam com todas as marcas.</translation></message>
<message><source>No setting separates these marks. Those that get most of them right come first.</source><translation>Nenhum ajuste separa estas marcas. Os que acertam a maioria vêm primeiro.</translation></message>
<message><source>click one end</source><translation>clique em uma extremidade</translation></message>
<message><source>click the other end</source><translation>clique na outra extremidade</translation></message>
<message><source>click the lower cell</source><translation>clique na célula mais baixa</translation></message>
<message><source>click the higher cell</source><translation>clique na célula mais alta</translation></message>
<message><source>click the end of one side</source><translation>clique na extremidade de um lado</translation></message>
<message><source>click where the sides meet</source><translation>clique onde os lados se encontram</translation></message>
<message><source>click the end of the other side</source><translation>clique na extremidade do outro lado</translation></message>
<message><source>click one end of a</source><translation>clique em uma extremidade de a</translation></message>
<message><source>click the other end of a</source><translation>clique na outra extremidade de a</translation></message>
<message><source>click one end of b</source><translation>clique em uma extremidade de b</translation></message>
<message><source>click the other end of b</source><translation>clique na outra extremidade de b</translation></message>
<message><source>click into the opening, or the near rock at one side</source><translation>clique na abertura, ou na rocha próxima de um lado</translation></message>
<message><source>click the rock at the other side</source><translation>clique na rocha do outro lado</translation></message>
<message><source>the throat could not be measured (%1); close other programs.</source><translation>não foi possível medir a garganta (%1); feche outros programas.</translation></message>
<message><source>Nothing was measured within %1 cells of this click, so no length ends there: click nearer to a surface.</source><translation>Nada foi medido a menos de %1 células deste clique, por isso nenhum comprimento termina aí: clique mais perto de uma superfície.</translation></message>
<message><source>Clicks next to this one find a throat of %1 to %2 m: zoom in, or click on the rock at both sides.</source><translation>Cliques junto a este encontram uma garganta de %1 a %2 m: aproxime a vista, ou clique na rocha dos dois lados.</translation></message>
<message><source>Clicks next to these find a throat of %1 to %2 m: zoom in and click on the rock at both sides, or once into the middle of the opening.</source><translation>Cliques junto a estes encontram uma garganta de %1 a %2 m: aproxime a vista e clique na rocha dos dois lados, ou uma vez no meio da abertura.</translation></message>
<message><source>The last click is in an opening and measures all of it: the click before does not count.</source><translation>O último clique está numa abertura e mede-a inteira: o clique anterior não conta.</translation></message>
<message><source>No opening between these two clicks: click the rock at both sides of one. Distance measures over a rock.</source><translation>Não há abertura entre estes dois cliques: clique na rocha dos dois lados de uma. Distância mede sobre uma rocha.</translation></message>
<message><source>A click went through the opening, so the rim in front of it was taken: check both ends of the line.</source><translation>Um clique passou pela abertura, por isso foi tomada a borda da frente: verifique as duas pontas da linha.</translation></message>
<message><source>An end of this measurement is %1 m behind the surface under its line: check where its ends are, and click again on the near side if that was meant.</source><translation>Uma extremidade desta medição está %1 m atrás da superfície sob a sua linha: verifique onde estão as extremidades e clique de novo no lado próximo, se era esse.</translation></message>
<message><source> · the last click took target %1, at %2 m</source><translation> · o último clique tomou o alvo %1, a %2 m</translation></message>
<message><source> · the last click took the near side, at %1 m</source><translation> · o último clique tomou o lado próximo, a %1 m</translation></message>
<message><source> · the last click is at %1 m</source><translation> · o último clique está a %1 m</translation></message>
<message><source>Throat width: the narrowest way is being searched …</source><translation>Largura da garganta: procurando a passagem mais estreita …</translation></message>
<message><source>Nothing was selected (%1).</source><translation>Nada foi selecionado (%1).</translation></message>
<message><source>Select Nothing</source><translation>Não selecionar nada</translation></message>
<message><source>Select</source><translation>Selecionar</translation></message>
<message><source>This cell is not an edge, so it is on no chain of edges: choose one that is.</source><translation>Esta célula não é uma borda, por isso não está em nenhuma cadeia de bordas: escolha uma que seja.</translation></message>
<message><source>This cell is not on a rock: choose a cell on a coloured face.</source><translation>Esta célula não está numa rocha: escolha uma célula sobre uma face colorida.</translation></message>
<message><source>Rocks are not shown, so none can be selected: show them first.</source><translation>As rochas não são mostradas, portanto nenhuma pode ser selecionada: mostre-as primeiro.</translation></message>
<message><source>Hide</source><translation>Ocultar</translation></message>
<message><source>Isolate</source><translation>Isolar</translation></message>
<message><source>Show All</source><translation>Mostrar tudo</translation></message>
<message><source>%1 cells selected, %2 points, %3 edge cells</source><translation>%1 células selecionadas, %2 pontos, %3 células de borda</translation></message>
<message><source>▲ %1 cells hidden</source><translation>▲ %1 células ocultas</translation></message>
<message><source>&amp;Isolate</source><translation>&amp;Isolar</translation></message>
<message><source>&amp;Select</source><translation>Se&amp;lecionar</translation></message>
<message><source>Edge &amp;Chain Here</source><translation>&amp;Cadeia de bordas aqui</translation></message>
<message><source>&amp;Rock Here</source><translation>&amp;Rocha aqui</translation></message>
<message><source>&amp;Hide Selected</source><translation>&amp;Ocultar a seleção</translation></message>
<message><source>&amp;Isolate Selected</source><translation>&amp;Isolar a seleção</translation></message>
<message><source>Show &amp;All</source><translation>&amp;Mostrar tudo</translation></message>
<message><source>&amp;Export Selected…</source><translation>Ex&amp;portar a seleção…</translation></message>
<message><source>There is no cell here: nothing more is hidden.</source><translation>Não há nenhuma célula ali: nada mais é ocultado.</translation></message>
<message><source>▲ The sweep grows. The cells that are there now are hidden. New lines are shown at every range.</source><translation>▲ A varredura continua. Ocultam-se as células que estão ali agora. As linhas novas são mostradas a qualquer distância.</translation></message>
<message><source>Range Gate</source><translation>Janela de distância</translation></message>
<message><source>No range is known there: click a cell, or point at one that has a range, first.</source><translation>Não se conhece distância ali: clique ou aponte primeiro uma célula que a tenha.</translation></message>
<message><source>Clip to Box</source><translation>Recortar a uma caixa</translation></message>
<message><source>The targets could not be stored (%1).</source><translation>Não foi possível guardar os alvos (%1).</translation></message>
<message><source>Your targets are not stored: %1</source><translation>Seus alvos não foram guardados: %1</translation></message>
<message><source>The targets could not be computed (%1).</source><translation>Não foi possível calcular os alvos (%1).</translation></message>
<message><source>Targets and measurements of the previous scan: %1. They are stored with it, as its edits of rocks are: open it again to see them.</source><translation>Alvos e medições da varredura anterior: %1. Estão salvos com ela, como suas correções de rochas: abra-a de novo para vê-los.</translation></message>
<message><source>Not stored: EdgeScan was started without its settings.</source><translation>Não salvo: o EdgeScan foi iniciado sem os seus ajustes.</translation></message>
<message><source>Not stored yet. Targets of a live sweep are stored when you open its recording, those of a part of a recording when its whole sweep is shown.</source><translation>Ainda não guardados. Os alvos de uma varredura ao vivo são guardados quando você abre a gravação; os de uma parte de uma gravação, quando a varredura inteira é mostrada.</translation></message>
<message><source>▲ Not stored: the targets of this scan were refused.</source><translation>▲ Não guardado: os alvos desta varredura foram recusados.</translation></message>
<message><source>Another window has this scan open, too. Targets and edits of rocks of both are stored together.</source><translation>Outra janela também tem esta varredura aberta. Os alvos e as edições de rochas de ambas são guardados juntos.</translation></message>
<message><source>This cell was not pinned: there are %1 targets, remove some first.</source><translation>Esta célula não foi fixada: há %1 alvos, primeiro remova alguns.</translation></message>
<message><source>new target %1</source><translation>novo alvo %1</translation></message>
<message><source>Target %1 is locked and stays: unlock it to remove it.</source><translation>O alvo %1 está bloqueado e fica: desbloqueie-o para removê-lo.</translation></message>
<message><source>removal of target %1</source><translation>remoção do alvo %1</translation></message>
<message><source>Target %1</source><translation>Alvo %1</translation></message>
<message><source>removal of all targets</source><translation>remoção de todos os alvos</translation></message>
<message><source>Targets %1</source><translation>Alvos %1</translation></message>
<message><source>1 locked target stays.</source><translation>Fica 1 alvo bloqueado.</translation></message>
<message><source>%1 locked targets stay.</source><translation>Ficam %1 alvos bloqueados.</translation></message>
<message><source>lock of target %1</source><translation>bloqueio do alvo %1</translation></message>
<message><source>unlocking of target %1</source><translation>desbloqueio do alvo %1</translation></message>
<message><source>This was not stored: there are %1 measurements, remove some first.</source><translation>Isto não foi guardado: há %1 medições, primeiro remova algumas.</translation></message>
<message><source>new measurement</source><translation>nova medição</translation></message>
<message><source>removal of measurement M%1</source><translation>remoção da medição M%1</translation></message>
<message><source>Another window changed the targets or measurements of this scan. Both are kept; of two with one number, yours has the next free one.</source><translation>Outra janela alterou os alvos ou as medições desta varredura. Ambos são mantidos; de dois com o mesmo número, o seu tem o próximo livre.</translation></message>
<message><source>rock %1</source><translation>rocha %1</translation></message>
<message><source>end %1 is target %2</source><translation>a ponta %1 é o alvo %2</translation></message>
<message><source>moved here from line %1, beam %2</source><translation>movido para cá desde linha %1, feixe %2</translation></message>
<message><source>up is assumed</source><translation>supõe-se onde é acima</translation></message>
<message><source>a cell of it has no range</source><translation>uma das suas células não tem distância</translation></message>
<message><source>locked</source><translation>bloqueado</translation></message>
<message><source>Pinned %1</source><translation>Fixado %1</translation></message>
<message><source>%1 warnings</source><translation>%1 avisos</translation></message>
<message><source>Target %1 is on the clipboard, as text.</source><translation>O alvo %1 está na área de transferência, como texto.</translation></message>
<message><source>On the clipboard, as a table for a spreadsheet: %1.</source><translation>Na área de transferência, como tabela para uma planilha: %1.</translation></message>
<message><source>Na&amp;me…</source><translation>No&amp;me…</translation></message>
<message><source>Meas&amp;ure from Here</source><translation>Medir daq&amp;ui</translation></message>
<message><source>Na&amp;me of Target %1…</source><translation>No&amp;me do alvo %1…</translation></message>
<message><source>No&amp;te on Target %1…</source><translation>No&amp;ta sobre o alvo %1…</translation></message>
<message><source>Unloc&amp;k Target %1</source><translation>&amp;Desbloquear o alvo %1</translation></message>
<message><source>Loc&amp;k Target %1</source><translation>&amp;Bloquear o alvo %1</translation></message>
<message><source>Remo&amp;ve Target %1</source><translation>Remo&amp;ver o alvo %1</translation></message>
<message><source>Name of a rock</source><translation>Nome de uma rocha</translation></message>
<message><source>Name of target %1, which is on this rock:</source><translation>Nome do alvo %1, que está nesta rocha:</translation></message>
<message><source>Name of this rock. A new target on it, number %1, holds the name:</source><translation>Nome desta rocha. Um novo alvo sobre ela, número %1, leva o nome:</translation></message>
<message><source>Name of a target</source><translation>Nome de um alvo</translation></message>
<message><source>Name of target %1:</source><translation>Nome do alvo %1:</translation></message>
<message><source>Nothing to name yet: pin a cell, or choose a target.</source><translation>Não há alvo a nomear: fixe uma célula ou escolha um alvo.</translation></message>
<message><source>Note on a target</source><translation>Nota sobre um alvo</translation></message>
<message><source>Note on target %1:</source><translation>Nota sobre o alvo %1:</translation></message>
<message><source>name of target %1</source><translation>nome do alvo %1</translation></message>
<message><source>note of target %1</source><translation>nota do alvo %1</translation></message>
<message><source>Open a scan: Ctrl+O, or drop a file here</source><translation>Abrir uma varredura: Ctrl+O, ou solte um arquivo aqui</translation></message>
<message><source>Coarse picture of %1 million cells, the rest is coming</source><translation>Imagem grosseira de %1 milhões de células, falta o resto</translation></message>
<message><source>The edges come with the rest of the scan</source><translation>As arestas chegam com o resto da varredura</translation></message>
<message><source>The scanner did not measure this place, or its point is hidden. Click the rock next to it.</source><translation>O scanner não mediu este lugar, ou o ponto dele está oculto. Clique na rocha ao lado.</translation></message>
<message><source>A is shown; go back to B to pin or to measure.</source><translation>A está à mostra; volte a B para fixar ou medir.</translation></message>
<message><source>Cells can be clicked when the whole scan is here: this is a coarse picture of it.</source><translation>Pode-se clicar nas células quando a varredura está completa: esta é uma imagem grosseira dela.</translation></message>
<message><source>&amp;Pin this cell</source><translation>&amp;Fixar esta célula</translation></message>
<message><source>&amp;Fly to this point</source><translation>&amp;Voar até este ponto</translation></message>
<message><source>View from &amp;scanner</source><translation>Vista a partir do s&amp;canner</translation></message>
<message><source>F&amp;it the cloud</source><translation>E&amp;nquadrar a nuvem</translation></message>
<message><source>Fit the &amp;images</source><translation>Enquadrar as &amp;imagens</translation></message>
<message><source>box of %1 × %2 cells: %3 points, %4 edge cells</source><translation>caixa de %1 × %2 células: %3 pontos, %4 células de borda</translation></message>
<message><source>, ranges %1 to %2 m</source><translation>, distâncias de %1 a %2 m</translation></message>
<message><source>%1: it failed (%2); close other programs or use a smaller scan.</source><translation>%1: falhou (%2); feche outros programas ou use uma varredura menor.</translation></message>
<message><source>the edges could not be computed (%1); close other programs or open a smaller scan.</source><translation>não foi possível calcular as bordas (%1); feche outros programas ou abra uma varredura menor.</translation></message>
<message><source>Opening %1</source><translation>Abrindo %1</translation></message>
<message><source>Making the demo draw-bell</source><translation>Criando o sino de demonstração</translation></message>
<message><source>Saving %1</source><translation>Salvando %1</translation></message>
<message><source>writing</source><translation>escrevendo</translation></message>
<message><source>being cancelled</source><translation>cancelando</translation></message>
<message><source>opened</source><translation>aberto</translation></message>
<message><source>reading</source><translation>leitura</translation></message>
<message><source>unpacking</source><translation>descompressão</translation></message>
<message><source>grid</source><translation>grade</translation></message>
<message><source>placing the points</source><translation>colocação dos pontos</translation></message>
<message><source>finding edges</source><translation>busca de arestas</translation></message>
<message><source>drawing</source><translation>desenho</translation></message>
<message><source>Menu</source><translation>Menu</translation></message>
<message><source>Connect</source><translation>Conectar</translation></message>
<message><source>Hold to leave</source><translation>Segurar: sair</translation></message>
<message><source>Hold for one second to leave cab mode</source><translation>Segurar um segundo para sair do modo cabine</translation></message>
<message><source>End of the menu</source><translation>Fim do menu</translation></message>
<message><source>Delete the last letter</source><translation>Apagar a última letra</translation></message>
<message><source>Enter</source><translation>Enter</translation></message>
<message><source>Close the keys</source><translation>Fechar as teclas</translation></message>
<message><source>Capital letter</source><translation>Maiúscula</translation></message>
<message><source>Space</source><translation>Espaço</translation></message>
<message><source>+ edges gained</source><translation>+ bordas ganhas</translation></message>
<message><source>− edges lost</source><translation>− bordas perdidas</translation></message>
<message><source>edges kept</source><translation>bordas mantidas</translation></message>
<message><source>? edges not seen</source><translation>? bordas não vistas</translation></message>
<message><source>surface nearer</source><translation>superfície mais perto</translation></message>
<message><source>surface farther</source><translation>superfície mais longe</translation></message>
<message><source>A has %1 edge cells: %2 lost, %3 next to edges of B, %4 without a point of B</source><translation>A tem %1 células de borda: %2 perdidas, %3 junto a bordas de B, %4 sem ponto de B</translation></message>
<message><source>B has %1 edge cells: %2 gained, %3 kept, %4 without a point of A</source><translation>B tem %1 células de borda: %2 novas, %3 mantidas, %4 sem ponto de A</translation></message>
<message><source>▲ OUT OF SPEC</source><translation>▲ FORA DE TOLERÂNCIA</translation></message>
<message><source>colour by distance from A</source><translation>cor conforme a distância a A</translation></message>
<message><source>cells</source><translation>células</translation></message>
<message><source>Other points have the colours of rocks</source><translation>Os outros pontos têm as cores das rochas</translation></message>
<message><source>Previous changed region</source><translation>Região alterada anterior</translation></message>
<message><source>Next changed region</source><translation>Próxima região alterada</translation></message>
<message><source>End</source><translation>Encerrar</translation></message>
<message><source>Ends the comparison: A is forgotten</source><translation>Encerra a comparação: A é esquecido</translation></message>
<message><source>Shows A; hold \ for a short look</source><translation>Mostra A; segure \ para vê-la por um momento</translation></message>
<message><source>Difference</source><translation>Diferença</translation></message>
<message><source>Shows B with what changed since A</source><translation>Mostra B com o que mudou desde A</translation></message>
<message><source>Shows B alone</source><translation>Mostra só B</translation></message>
<message><source>comparing …</source><translation>comparando …</translation></message>
<message><source>comparing …
Gray counts are older.</source><translation>comparando …
Os números cinza são anteriores.</translation></message>
<message><source>not compared with the scan on the screen</source><translation>não comparado com a varredura na tela</translation></message>
<message><source>nothing to compare with yet:
change a setting, or open another scan</source><translation>nada ainda para comparar:
mude um ajuste ou abra outra varredura</translation></message>
<message><source>median difference along the beams %1 mm
a change is more than %2 mm at 5 m</source><translation>diferença mediana ao longo dos feixes %1 mm
uma mudança passa de %2 mm a 5 m</translation></message>
<message><source>median distance to the points of A %1
%2 are farther than %3</source><translation>distância mediana aos pontos de A %1
%2 estão a mais de %3</translation></message>
<message><source>Next</source><translation>Seguinte</translation></message>
<message><source>Folds the legend</source><translation>Recolhe a legenda</translation></message>
<message><source>Unfolds the legend</source><translation>Expande a legenda</translation></message>
<message><source>Changes: %1</source><translation>Mudanças: %1</translation></message>
<message><source>A, after: %1</source><translation>A, depois: %1</translation></message>
<message><source>A, before: %1</source><translation>A, antes: %1</translation></message>
<message><source>B, before: %1</source><translation>B, antes: %1</translation></message>
<message><source>B, after: %1</source><translation>B, depois: %1</translation></message>
<message><source>A: %1</source><translation>A: %1</translation></message>
<message><source>at all of them</source><translation>com todos</translation></message>
<message><source>below %1 %</source><translation>menos de %1 %</translation></message>
<message><source>%1 % and more</source><translation>%1 % e mais</translation></message>
<message><source>Confidence of edges</source><translation>Confiança das bordas</translation></message>
<message><source>Edges that fewer of the nearby settings find are left out of the views. Exports have all of them.</source><translation>As bordas que menos ajustes próximos encontram são omitidas nas vistas; as exportações contêm todas.</translation></message>
<message><source>Least confidence shown</source><translation>Confiança mínima mostrada</translation></message>
<message><source>Shown: %1 % and more</source><translation>Mostrado: %1 % e mais</translation></message>
<message><source>Shown: all</source><translation>Mostrado: tudo</translation></message>
<message><source>computing: %1 %</source><translation>calculando: %1 %</translation></message>
<message><source>share of %1 nearby settings that find the edge</source><translation>parte dos %1 ajustes próximos que encontram a borda</translation></message>
<message><source>No command has these words, or it cannot be used now.</source><translation>Nenhum comando tem estas palavras, ou não pode ser usado agora.</translation></message>
<message><source>Commands</source><translation>Comandos</translation></message>
<message><source>A few letters of a command</source><translation>Algumas letras de um comando</translation></message>
<message><source>For the program that will read it</source><translation>Para o programa que o lerá</translation></message>
<message><source>Only what is selected (%1 cells)</source><translation>Só o que está selecionado (%1 células)</translation></message>
<message><source>Also the points that lie behind the nearest of their cell (%1 in the scan)</source><translation>Também os pontos situados atrás do mais próximo da sua célula (%1 na varredura)</translation></message>
<message><source>Choose File…</source><translation>Escolher arquivo…</translation></message>
<message><source>What</source><translation>Conteúdo</translation></message>
<message><source>It draws edge lines: choose the edge points above.</source><translation>Desenha linhas de bordas: escolha acima os pontos de borda.</translation></message>
<message><source>Targets are written as a table or a drawing.</source><translation>Os alvos são escritos como tabela ou desenho.</translation></message>
<message><source>The file holds x, y and z in metres from the scanner.</source><translation>O arquivo contém x, y e z em metros a partir do scanner.</translation></message>
<message><source>The file holds metres from E %1, N %2, RL %3: a program that does not add these shows small numbers.</source><translation>O arquivo contém metros a partir de E %1, N %2, RL %3: um programa que não os soma mostra números pequenos.</translation></message>
<message><source>The file holds Easting, Northing and RL in metres.</source><translation>O arquivo contém as coordenadas leste e norte e o RL em metros.</translation></message>
<message><source>Choose local metres for %1: numbers of 4 bytes would round them to steps of %2 mm.</source><translation>Escolha metros locais para %1: números de 4 bytes os arredondariam em passos de %2 mm.</translation></message>
<message><source>Numbers count from the scanner, along its own axes.</source><translation>Os números contam a partir do scanner, ao longo dos seus próprios eixos.</translation></message>
<message><source>Small numbers: metres east, north and up from an origin near the scan. To get mine coordinates, add the origin, which is in the header or in the record of the file.</source><translation>Números pequenos: metros para leste, norte e cima a partir de uma origem perto da varredura. Para ter coordenadas da mina, some a origem, que está no cabeçalho ou no registro do arquivo.</translation></message>
<message><source>Each point has its whole Easting, Northing and RL, as on the plans of the mine.</source><translation>Cada ponto tem seu Leste, Norte e RL inteiros, como nas plantas da mina.</translation></message>
<message><source>The column elevation_m is the RL.</source><translation>A coluna elevation_m é a RL.</translation></message>
<message><source>The file holds metres from an origin near the scan, because %1 programs round mine coordinates. EdgeScan adds the origin of the header when it opens the file; other programs show the small numbers.</source><translation>O arquivo contém metros a partir de uma origem perto da varredura, porque os programas de %1 arredondam as coordenadas da mina. O EdgeScan soma a origem do cabeçalho ao abrir o arquivo; outros programas mostram os números pequenos.</translation></message>
<message><source>Coordinates</source><translation>Coordenadas</translation></message>
<message><source>Mine grid: Easting, Northing, RL</source><translation>Coordenadas da mina: E, N, RL</translation></message>
<message><source>Local metres from an origin in the mine grid</source><translation>Metros locais a partir de uma origem em coordenadas da mina</translation></message>
<message><source>Scanner frame, as measured</source><translation>Sistema do scanner, como medido</translation></message>
<message><source>No mine grid: %1. Scan &gt; Pose and Mounting takes a pose and a calibration.</source><translation>Sem coordenadas da mina: %1. Varredura &gt; Pose e montagem aceita uma pose e uma calibração.</translation></message>
<message><source>%1 × %2 pixels</source><translation>%1 × %2 pixels</translation></message>
<message><source>Lines through %1 edge points will be saved.</source><translation>Serão salvas linhas que passam por %1 pontos de borda.</translation></message>
<message><source>%1 points will be saved.</source><translation>%1 pontos serão salvos.</translation></message>
<message><source>%1 will be saved.</source><translation>A guardar: %1.</translation></message>
<message><source>%1 cells will be saved.</source><translation>%1 células serão salvas.</translation></message>
<message><source>doubtful</source><translation>duvidoso</translation></message>
<message><source>detected</source><translation>deduzido</translation></message>
<message><source>assumed</source><translation>suposto</translation></message>
<message><source>given by you</source><translation>como indicado</translation></message>
<message><source>from the file</source><translation>segundo o arquivo</translation></message>
<message><source>Does This Look Right?</source><translation>Parece correto?</translation></message>
<message><source>&amp;Close</source><translation>&amp;Fechar</translation></message>
<message><source>&amp;Adopt</source><translation>&amp;Adotar</translation></message>
<message><source>or</source><translation>ou</translation></message>
<message><source>%1: there is no other way to read it.</source><translation>%1: não há outra forma de lê-lo.</translation></message>
<message><source>%1: something contradicts how it was read.</source><translation>%1: algo contradiz como foi lido.</translation></message>
<message><source>%1: assumed (%2), and the scan itself does not contradict it.</source><translation>%1: suposto (%2), e o próprio escaneamento não o contradiz.</translation></message>
<message><source>%1: nothing contradicts how it was read.</source><translation>%1: nada contradiz como foi lido.</translation></message>
<message><source>Click another reading to see the scan read that way. Adopt takes it, and Ctrl+Z undoes that. Close restores the former reading.</source><translation>Clique em outra leitura para ver a varredura lida assim. Adotar a toma, e Ctrl+Z o desfaz. Fechar restaura a leitura anterior.</translation></message>
<message><source>grid north</source><translation>norte da quadrícula</translation></message>
<message><source>true north</source><translation>norte verdadeiro</translation></message>
<message><source>the vertical</source><translation>a vertical</translation></message>
<message><source>the robot's z axis</source><translation>o eixo z do robô</translation></message>
<message><source>forward</source><translation>para a frente</translation></message>
<message><source>up</source><translation>para cima</translation></message>
<message><source>down</source><translation>para baixo</translation></message>
<message><source>by three angles</source><translation>segundo três ângulos</translation></message>
<message><source>by nine numbers</source><translation>segundo nove números</translation></message>
<message><source>two elevations</source><translation>duas elevações</translation></message>
<message><source>pitch and roll</source><translation>arfagem e rolagem</translation></message>
<message><source>Pose and Mounting</source><translation>Pose e montagem</translation></message>
<message><source>Mounting</source><translation>Montagem</translation></message>
<message><source>&amp;Store with the Scan</source><translation>&amp;Guardar com a varredura</translation></message>
<message><source>&amp;Remove Pose</source><translation>&amp;Remover a pose</translation></message>
<message><source>&amp;Fill In</source><translation>&amp;Preencher</translation></message>
<message><source>A line of the survey: point, E, N, RL, and heading, pitch and roll if it has them. E is easting, N northing, RL the height above the mine's zero: a higher place has a larger RL.</source><translation>Uma linha do levantamento: ponto, E, N, RL, e rumo, arfagem e rolagem se os tiver. E é a coordenada este, N a norte, RL a altura acima do zero da mina: um lugar mais alto tem um RL maior.</translation></message>
<message><source>How the scanner is mounted, under a name for the next scan. An empty field has the value shown in it.</source><translation>Como o scanner está montado, com um nome para a próxima varredura. Um campo vazio tem o valor que mostra.</translation></message>
<message><source>Store &amp;As…</source><translation>Guardar &amp;como…</translation></message>
<message><source>For&amp;get</source><translation>&amp;Esquecer</translation></message>
<message><source>From Fi&amp;le…</source><translation>De um &amp;arquivo…</translation></message>
<message><source>✕ missing</source><translation>✕ falta</translation></message>
<message><source>Nominal mounting</source><translation>Montagem nominal</translation></message>
<message><source>Settings for these marks</source><translation>Ajustes para estas marcas</translation></message>
<message><source>Click a row to see it. Adopt takes it. Close restores the former settings.</source><translation>Clique em uma linha para vê-la. Adotar a toma. Fechar restaura os ajustes anteriores.</translation></message>
<message><source>Range gate</source><translation>Janela de distância</translation></message>
<message><source>Draw cells from</source><translation>Desenhar células de</translation></message>
<message><source>to</source><translation>até</translation></message>
<message><source>All others are hidden in all views. Edges, counts and exports stay as they are.</source><translation>Todas as outras são ocultadas em todas as vistas. Bordas, contagens e exportações ficam como estão.</translation></message>
<message><source>An empty field: from the file, or detected. The file itself is not changed.</source><translation>Um campo vazio: do arquivo, ou detectado. O próprio arquivo não é alterado.</translation></message>
<message><source>Read Again</source><translation>Ler de novo</translation></message>
<message><source>as in the file</source><translation>como no arquivo</translation></message>
<message><source>Choose…</source><translation>Escolher…</translation></message>
<message><source>in the report</source><translation>no relatório</translation></message>
<message><source>HTML: a page for any browser</source><translation>HTML: uma página para qualquer navegador</translation></message>
<message><source>PDF: pages to print and to file</source><translation>PDF: páginas para imprimir e arquivar</translation></message>
<message><source>Author</source><translation>Autor</translation></message>
<message><source>Logo (PNG)</source><translation>Logotipo (PNG)</translation></message>
<message><source>SHA-256</source><translation>SHA-256</translation></message>
<message><source>Scan lines</source><translation>Linhas da varredura</translation></message>
<message><source>Beams</source><translation>Feixes</translation></message>
<message><source>Cells</source><translation>Células</translation></message>
<message><source>with a range</source><translation>com distância</translation></message>
<message><source>Ranges [m]</source><translation>Distâncias [m]</translation></message>
<message><source>smallest</source><translation>a menor</translation></message>
<message><source>largest</source><translation>a maior</translation></message>
<message><source>Unit of the file [mm]</source><translation>Unidade do arquivo [mm]</translation></message>
<message><source>Geometry</source><translation>Geometria</translation></message>
<message><source>Mounting of the stepper</source><translation>Montagem do motor de passo</translation></message>
<message><source>Beam angles [°]</source><translation>Ângulos dos feixes [°]</translation></message>
<message><source>Line angles [°]</source><translation>Ângulos das linhas [°]</translation></message>
<message><source>Intensity</source><translation>Intensidade</translation></message>
<message><source>Maker</source><translation>Fabricante</translation></message>
<message><source>Model</source><translation>Modelo</translation></message>
<message><source>Serial number</source><translation>Número de série</translation></message>
<message><source>Firmware</source><translation>Firmware</translation></message>
<message><source>Begin (UTC)</source><translation>Início (UTC)</translation></message>
<message><source>End (UTC)</source><translation>Fim (UTC)</translation></message>
<message><source>Clock</source><translation>Relógio</translation></message>
<message><source>Window of the scanner</source><translation>Janela do scanner</translation></message>
<message><source>Echo filter</source><translation>Filtro de ecos</translation></message>
<message><source>Lines of the sweep</source><translation>Linhas da varredura</translation></message>
<message><source>first</source><translation>primeira</translation></message>
<message><source>last</source><translation>última</translation></message>
<message><source>number</source><translation>número</translation></message>
<message><source>step</source><translation>passo</translation></message>
<message><source>uneven</source><translation>desigual</translation></message>
<message><source>Direction of the stepper</source><translation>Sentido do motor</translation></message>
<message><source>Points behind others</source><translation>Pontos atrás de outros</translation></message>
<message><source>Points of the list</source><translation>Pontos da lista</translation></message>
<message><source>in the file</source><translation>no arquivo</translation></message>
<message><source>without a cell</source><translation>sem célula</translation></message>
<message><source>Scanner at [m]</source><translation>Scanner em [m]</translation></message>
<message><source>Origin E, N, RL [m]</source><translation>Origem E, N, RL [m]</translation></message>
<message><source>Source</source><translation>Origem</translation></message>
<message><source>Begin of the scan</source><translation>Início da varredura</translation></message>
<message><source>End of the scan</source><translation>Fim da varredura</translation></message>
<message><source>Time of the pose</source><translation>Hora da pose</translation></message>
<message><source>Age of the pose [s]</source><translation>Idade da pose [s]</translation></message>
<message><source>Out of spec</source><translation>Fora das tolerâncias</translation></message>
<message><source>Poses</source><translation>Poses</translation></message>
<message><source>Boom</source><translation>Lança</translation></message>
<message><source>Pivot [m]</source><translation>Pivô [m]</translation></message>
<message><source>Head [m]</source><translation>Cabeça [m]</translation></message>
<message><source>scanner</source><translation>scanner</translation></message>
<message><source>beam x line angles</source><translation>ângulos de feixes x linhas</translation></message>
<message><source>organised points</source><translation>pontos organizados</translation></message>
<message><source>spin</source><translation>spin</translation></message>
<message><source>sweep</source><translation>sweep</translation></message>
<message><source>yes</source><translation>sim</translation></message>
<message><source>no</source><translation>não</translation></message>
<message><source>and %1 more</source><translation>e mais %1</translation></message>
<message><source>&lt;h3&gt;Mouse in the cloud&lt;/h3&gt;Left drag turns, middle drag or Shift+left drag pans, right drag or wheel zooms, Ctrl+left drag rolls; double-click or middle click sets the centre of rotation; Alt+wheel point size, Ctrl+wheel near clip, Ctrl+Shift+wheel far clip.&lt;h3&gt;Mouse in the images&lt;/h3&gt;Left or middle drag pans, wheel zooms, right drag changes the display levels, double-click fits; Shift+drag looks closer.&lt;h3&gt;Mouse in all views&lt;/h3&gt;A click pins a target; while rocks are shown, it selects the rock there, and Shift+click pins. Ctrl+click selects one more rock. A right click opens the menu of the cell.</source><translation>&lt;h3&gt;Mouse na nuvem de pontos&lt;/h3&gt;Arrastar com o esquerdo gira, com o do meio ou Shift+esquerdo desloca, com o direito ou a roda aproxima e afasta, Ctrl+esquerdo inclina; clique duplo ou clique do meio define o centro de rotação; Alt+roda tamanho dos pontos, Ctrl+roda plano de corte próximo, Ctrl+Shift+roda plano de corte distante.&lt;h3&gt;Mouse nas imagens&lt;/h3&gt;Arrastar com o esquerdo ou o do meio desloca, a roda aproxima e afasta, arrastar com o direito muda os níveis mostrados, clique duplo ajusta; Shift+arrastar olha de perto.&lt;h3&gt;Mouse em todas as vistas&lt;/h3&gt;Um clique fixa um alvo; enquanto as rochas são mostradas, seleciona a rocha que está ali, e Shift+clique fixa. Ctrl+clique seleciona mais uma rocha. Um clique direito abre o menu da célula.</translation></message>
<message><source>Keys</source><translation>Teclas</translation></message>
<message><source>Keys and mouse</source><translation>Teclado e mouse</translation></message>
<message><source>Scan</source><translation>Varredura</translation></message>
<message><source>About EdgeScan</source><translation>Sobre o EdgeScan</translation></message>
<message><source>&lt;h3&gt;EdgeScan %1&lt;/h3&gt;Finds the edges of rocks in a laser range scan and shows them in the cloud.&lt;br&gt;It shows geometry from one viewpoint. It does not judge any rock.&lt;br&gt;&lt;br&gt;Licence: BSD-3-Clause&lt;br&gt;Drawn by %2</source><translation>&lt;h3&gt;EdgeScan %1&lt;/h3&gt;Encontra as bordas das rochas em uma varredura a laser de distâncias e as mostra na nuvem de pontos.&lt;br&gt;O que mostra é geometria vista de um só ponto; não é um julgamento sobre nenhuma rocha.&lt;br&gt;&lt;br&gt;Licença: BSD-3-Clause&lt;br&gt;Desenhado por %2</translation></message>
<message><source>along the line</source><translation>ao longo da linha</translation></message>
<message><source>across the lines</source><translation>através das linhas</translation></message>
<message><source>%1: %2 m wide, %3 m deep (drawn × %4), near is below</source><translation>%1: %2 m de largura, %3 m de profundidade (desenhada × %4), o próximo está embaixo</translation></message>
<message><source>; ▲ ▼: points beyond it</source><translation>; ▲ ▼: pontos além dele</translation></message>
<message><source>Numbers</source><translation>Números</translation></message>
<message><source>Why the edge %1 cells away?</source><translation>Por que a borda a %1 células?</translation></message>
<message><source>More</source><translation>Mais</translation></message>
<message><source>Why is this cell an edge or not?</source><translation>Por que esta célula é uma borda, ou não?</translation></message>
<message><source>The points across the cell, and a line through the nearest of either side.</source><translation>Os pontos através da célula, e uma reta pelos mais próximos de cada lado.</translation></message>
<message><source>The verdict in the method's terms, the points across the cell, and the numbers</source><translation>O veredito nos termos do método, os pontos através da célula e os números</translation></message>
<message><source>Less</source><translation>Menos</translation></message>
<message><source>Why the edge next to it?</source><translation>Por que a borda ao lado?</translation></message>
<message><source>stones boulders fragments sizes</source><translation>pedras blocos matacões fragmentos tamanhos</translation></message>
<message><source>export csv table list of rocks dxf outlines</source><translation>exportar csv tabela lista de rochas dxf contornos</translation></message>
<message><source>wider widest biggest boulder oversize</source><translation>mais larga maior matacão acima do tamanho</translation></message>
<message><source>export csv table edge list points</source><translation>exportar csv tabela lista de bordas pontos</translation></message>
<message><source>export csv table all points las</source><translation>exportar csv tabela todos os pontos las</translation></message>
<message><source>export csv table pins measurements</source><translation>exportar csv tabela marcas medidas</translation></message>
<message><source>print pdf paper page</source><translation>imprimir pdf papel página</translation></message>
<message><source>picture image of the window</source><translation>imagem captura da janela</translation></message>
<message><source>refresh read again</source><translation>atualizar ler de novo</translation></message>
<message><source>compare before after change difference</source><translation>comparar antes depois mudança diferença</translation></message>
<message><source>off</source><translation>desligado</translation></message>
<message><source>on</source><translation>ligado</translation></message>
<message><source>Add a Scan as a Layer…</source><translation>Adicionar varredura como camada…</translation></message>
<message><source>Remove</source><translation>Remover</translation></message>
<message><source>Place by Targets</source><translation>Posicionar por alvos</translation></message>
<message><source>Shows the image and the edges of this scan; the others stay in the cloud</source><translation>Mostra a imagem e as bordas desta varredura; as outras ficam na nuvem</translation></message>
<message><source>Pin the same three places in both scans as targets with the same numbers: they bring the layer to its place</source><translation>Marque os mesmos três lugares nas duas varreduras como alvos com os mesmos números: eles põem a camada no lugar</translation></message>
<message><source>ANOTHER PICTURE</source><translation>OUTRA IMAGEM</translation></message>
<message><source>CONNECTED, another picture is shown</source><translation>CONECTADO, outra imagem é mostrada</translation></message>
<message><source>now sweep %1: %2</source><translation>agora varredura %1: %2</translation></message>
<message><source>sweep %1: %2</source><translation>varredura %1: %2</translation></message>
<message><source>Lines whose telegrams did not arrive: dashes in the images</source><translation>Linhas cujos telegramas não chegaram: traços nas imagens</translation></message>
<message><source>Port</source><translation>Porta</translation></message>
<message><source>EdgeScan sends only read requests and one subscription to the scanner</source><translation>Ao scanner só são enviadas leituras e uma assinatura</translation></message>
<message><source>Record</source><translation>Gravar</translation></message>
<message><source>Write every telegram to a new file, unchanged, as it arrives</source><translation>Escrever cada telegrama em um arquivo novo, sem tocar nele, à medida que chega</translation></message>
<message><source>Keep last minute</source><translation>Conservar o último minuto</translation></message>
<message><source>Write what arrived during the last minute to a new file</source><translation>Escrever em um arquivo novo o que chegou durante o último minuto</translation></message>
<message><source>Hold</source><translation>Reter</translation></message>
<message><source>The picture stays as it is while the scanner goes on.</source><translation>A imagem fica como está enquanto o scanner continua.</translation></message>
<message><source>Follow</source><translation>Seguir</translation></message>
<message><source>The picture grows with the scanner.</source><translation>A imagem cresce com o scanner.</translation></message>
<message><source>scanner, or ws://ROBOT</source><translation>scanner, ou ws://ROBOT</translation></message>
<message><source>Name or address of the scanner; ws://ROBOT is a robot with ROS on which foxglove_bridge runs</source><translation>Nome ou endereço do scanner; ws://ROBOT é um robô com ROS em que corre o foxglove_bridge</translation></message>
<message><source>Name or address of the scanner</source><translation>Nome ou endereço do scanner</translation></message>
<message><source>Port of the scanner</source><translation>Porta do scanner</translation></message>
<message><source>Sweep…</source><translation>Varredura…</translation></message>
<message><source>Lines of a sweep, step per line, mounting</source><translation>Linhas de uma varredura, passo por linha, montagem</translation></message>
<message><source>Stop</source><translation>Parar</translation></message>
<message><source>Stop recording</source><translation>Parar a gravação</translation></message>
<message><source>Show another sweep…</source><translation>Mostrar outra varredura…</translation></message>
<message><source>Show %1</source><translation>Mostrar: %1</translation></message>
<message><source>%1 is written, but the disk has not confirmed the last %2 kB: keep the power on until it is idle.</source><translation>%1 está escrito, mas o disco não confirmou os últimos %2 kB: não desligue a alimentação até que ele esteja inativo.</translation></message>
<message><source>Lines of the sweep. A red mark is a line that did not arrive.</source><translation>Linhas da varredura; uma marca vermelha é uma linha que nunca chegou</translation></message>
<message><source>not known</source><translation>desconhecido</translation></message>
<message><source>not known (%1° assumed)</source><translation>não se sabe (%1° suposto)</translation></message>
<message><source>Does not turn while a line is measured</source><translation>Fica parado enquanto uma linha é medida</translation></message>
<message><source>Where the stepper begins. The cloud turns with it, its shape is the same.</source><translation>Onde o motor começa. A nuvem gira com ele, a forma é a mesma.</translation></message>
<message><source>0: no encoder; the lines are placed by the stepper's step</source><translation>0: sem encoder; as linhas são posicionadas pelo passo do motor</translation></message>
<message><source>spin: like a wheel, about its viewing direction</source><translation>spin: como uma roda, em torno da sua direção de visão</translation></message>
<message><source>sweep: nodding, about the line from beam 0° to 180°</source><translation>sweep: balançando, em torno da linha do feixe 0° ao 180°</translation></message>
<message><source>The numbers are in the stepper's program or data sheet. Leave out what you do not know.</source><translation>Os números estão no programa ou na ficha técnica do motor de passo. Deixe o que não souber.</translation></message>
<message><source>The scanner turns</source><translation>O scanner gira</translation></message>
<message><source>Lines of a whole sweep</source><translation>Linhas de uma varredura inteira</translation></message>
<message><source>Turn of a whole sweep</source><translation>Giro de uma varredura inteira</translation></message>
<message><source>Step per line</source><translation>Passo por linha</translation></message>
<message><source>Angle of the first line</source><translation>Ângulo da primeira linha</translation></message>
<message><source>Encoder counts per degree</source><translation>Contagens do encoder por grau</translation></message>
<message><source>not known (spin assumed until the ranges show it)</source><translation>não se sabe (spin suposto até que as distâncias o mostrem)</translation></message>
<message><source>not known (the ranges show spin)</source><translation>não se sabe (as distâncias mostram spin)</translation></message>
<message><source>not known (the ranges show sweep)</source><translation>não se sabe (as distâncias mostram sweep)</translation></message>
<message><source>needs the number of lines</source><translation>requer o número de linhas</translation></message>
<message><source>Play</source><translation>Reproduzir</translation></message>
<message><source>Space plays and pauses; Left and Right step by a line, with Shift by ten</source><translation>Espaço reproduz e pausa; Esquerda e Direita avançam uma linha, com Shift dez</translation></message>
<message><source>RECORDED · line %2/%3 at %1</source><translation>GRAVADO · linha %2/%3 em %1</translation></message>
<message><source> · recorded sweep %1 of %2</source><translation> · varredura gravada %1 de %2</translation></message>
<message><source>Pause</source><translation>Pausar</translation></message>
<message><source>%1; messages: %2, per second: %3</source><translation>%1; mensagens: %2, por segundo: %3</translation></message>
<message><source>Topics…</source><translation>Tópicos…</translation></message>
<message><source>What the robot offers, and which laser the scan comes from</source><translation>O que o robô oferece, e de que laser vem a varredura</translation></message>
<message><source>The robot has not offered a topic yet.</source><translation>O robô ainda não ofereceu nenhum tópico.</translation></message>
<message><source>clouds of %1 points</source><translation>nuvens de %1 pontos</translation></message>
<message><source>clouds of a scanner</source><translation>nuvens de um scanner</translation></message>
<message><source>lines of %1 beams</source><translation>linhas de %1 feixes</translation></message>
<message><source>lines of a laser</source><translation>linhas de um laser</translation></message>
<message><source>Angle of each line</source><translation>Ângulo de cada linha</translation></message>
<message><source>from the transforms, or from the joint that turned furthest</source><translation>segundo as transformações, ou a junta que mais girou</translation></message>
<message><source>from the joint %1</source><translation>segundo a junta %1</translation></message>
<message><source>Topics that are not used: %1</source><translation>Tópicos que não são usados: %1</translation></message>
<message><source>A part of rock %1 (%2 cells) is not shown as a rock: </source><translation>Uma parte da rocha %1 (%2 células) não é mostrada como rocha: </translation></message>
<message><source>it is smaller than “Smallest rock” (%1 cells). Lower that number to see it.</source><translation>é menor que “Menor rocha” (%1 células). Diminua esse número para vê-la.</translation></message>
<message><source>it is outside the region of interest. Clear the region to see it.</source><translation>está fora da região de interesse. Apague a região para vê-la.</translation></message>
<message><source>its confidence is %1, and a rock needs %2. Click it and choose “Not a Rock, or a Rock Again” to show it.</source><translation>a sua confiança é %1, e uma rocha precisa de %2. Clique nela e escolha “Não é rocha, ou é sim” para mostrá-la.</translation></message>
<message><source>it is behind “Farthest rock” (%1 m). Raise that number to see it.</source><translation>está além de “Rocha mais distante” (%1 m). Aumente esse número para vê-la.</translation></message>
<message><source>it looks like a wall. Click it and choose “Not a Rock, or a Rock Again” to show it.</source><translation>parece uma parede. Clique nela e escolha “Não é rocha, ou é sim” para mostrá-la.</translation></message>
<message><source>Merged: rocks %1 are rock %2 now.</source><translation>Mescladas: as rochas %1 são agora a rocha %2.</translation></message>
<message><source>Cut: rock %1 is now rocks %2.</source><translation>Cortada: a rocha %1 agora é as rochas %2.</translation></message>
<message><source>Split: rock %1 is now rocks %2.</source><translation>Dividida: a rocha %1 agora é as rochas %2.</translation></message>
<message><source>Rocks %1 and %2 do not touch: their nearest cells are %3 m apart.</source><translation>As rochas %1 e %2 não se tocam: as suas células mais próximas estão a %3 m uma da outra.</translation></message>
<message><source>Rock %1 and a part that was not a rock do not touch: their nearest cells are %2 m apart.</source><translation>A rocha %1 e uma parte que não era rocha não se tocam: as suas células mais próximas estão a %2 m uma da outra.</translation></message>
<message><source>They are merged as rock %1.</source><translation>Estão mescladas como rocha %1.</translation></message>
<message><source>at least %1</source><translation>pelo menos %1</translation></message>
<message><source>something that is not a rock</source><translation>algo que não é uma rocha</translation></message>
<message><source>none seen</source><translation>nada à vista</translation></message>
<message><source>at least 1: rock %1</source><translation>pelo menos 1: rocha %1</translation></message>
<message><source>at least %1: rocks %2</source><translation>pelo menos %1: rochas %2</translation></message>
<message><source>, between rocks %1 and %2</source><translation>, entre as rochas %1 e %2</translation></message>
<message><source>, hangs below</source><translation>, pende por baixo</translation></message>
<message><source>nothing was measured here, or no piece fits</source><translation>nada foi medido aqui, ou nenhum pedaço corresponde</translation></message>
<message><source>fines: too few cells to be shown as a rock</source><translation>finos: células de menos para mostrá-los como uma rocha</translation></message>
<message><source>outside the region of interest</source><translation>fora da região de interesse</translation></message>
<message><source>marked by hand as not a rock</source><translation>marcada à mão como não rocha</translation></message>
<message><source>too uncertain to be shown as a rock</source><translation>incerto demais para ser mostrado como rocha</translation></message>
<message><source>wall, floor, or too far away</source><translation>parede, piso, ou longe demais</translation></message>
<message><source>Name…</source><translation>Nome…</translation></message>
<message><source>Section</source><translation>Secção</translation></message>
<message><source>Split</source><translation>Dividir</translation></message>
<message><source>Cut</source><translation>Cortar</translation></message>
<message><source>Merge</source><translation>Mesclar</translation></message>
<message><source>Not a Rock</source><translation>Não é rocha</translation></message>
<message><source>Deselect this rock</source><translation>Desmarcar esta rocha</translation></message>
<message><source>Hidden parts are not counted.</source><translation>As partes ocultas não são contadas.</translation></message>
<message><source>Then click the part of the rock that is a rock of its own; the wheel takes a smaller or a larger part (S)</source><translation>Depois clique na parte da rocha que é uma rocha à parte; a roda toma uma parte menor ou maior (S)</translation></message>
<message><source>Then draw a line through the rock, from one side to the other (X)</source><translation>Depois trace uma linha através da rocha, de um lado ao outro (X)</translation></message>
<message><source>A target on this rock holds its name (F2)</source><translation>Um alvo nesta rocha leva o seu nome (F2)</translation></message>
<message><source>The vertical plane through the rock, along its longest visible width</source><translation>O plano vertical pela rocha, ao longo da sua maior largura visível</translation></message>
<message><source>The selected rocks are one; Ctrl+click selects several (M)</source><translation>As rochas selecionadas são uma só; Ctrl+clique seleciona várias (M)</translation></message>
<message><source>%1, and %2 more selected</source><translation>%1, e mais %2 selecionadas</translation></message>
<message><source>▲ uncertain outline: hatched</source><translation>▲ contorno incerto: hachurado</translation></message>
<message><source>may be one with %1: Merge joins them</source><translation>pode ser uma só com %1: Mesclar junta-as</translation></message>
<message><source>a rock by hand: marked or cut</source><translation>uma rocha à mão: marcada ou cortada</translation></message>
<message><source>A Rock</source><translation>É rocha</translation></message>
<message><source>This is a wall, a floor or something else (N)</source><translation>Isto é uma parede, um piso ou outra coisa (N)</translation></message>
<message><source>This is a rock (N)</source><translation>É uma rocha, sim (N)</translation></message>
<message><source>Rock %1</source><translation>Rocha %1</translation></message>
<message><source>visible spans a × b</source><translation>extensões visíveis a × b</translation></message>
<message><source>distance, median</source><translation>distância, mediana</translation></message>
<message><source>visible area</source><translation>área visível</translation></message>
<message><source>%1 m²</source><translation>%1 m²</translation></message>
<message><source>in front</source><translation>na frente</translation></message>
<message><source>%1 % of its outline</source><translation>%1 % do seu contorno</translation></message>
<message><source>behind rocks</source><translation>atrás das rochas</translation></message>
<message><source>visible contacts</source><translation>contatos visíveis</translation></message>
<message><source>free height below</source><translation>altura livre abaixo</translation></message>
<message><source>arch angle</source><translation>ângulo do arco</translation></message>
<message><source>the scanner's z axis, assumed</source><translation>o eixo z do scanner, suposto</translation></message>
<message><source>confidence p</source><translation>confiança p</translation></message>
<message><source>pinned target</source><translation>alvo fixado</translation></message>
<message><source>Not a rock</source><translation>Não é rocha</translation></message>
<message><source>because</source><translation>porque</translation></message>
<message><source>▲ %1 parts that do not touch, %2 m apart</source><translation>▲ %1 partes que não se tocam, a %2 m</translation></message>
<message><source>%1 and %2</source><translation>%1 e %2</translation></message>
<message><source>≈ may be one with %1</source><translation>≈ pode ser uma só com %1</translation></message>
<message><source>%1 · visible a × b: %2 × %3 m ± %4 m · at %5 m</source><translation>%1 · a × b visível: %2 × %3 m ± %4 m · a %5 m</translation></message>
<message><source> · ▲ uncertain outline</source><translation> · ▲ contorno incerto</translation></message>
<message><source>hide uncertain</source><translation>ocultar incertas</translation></message>
<message><source>Export…</source><translation>Exportar…</translation></message>
<message><source>Rocks with a smaller visible width b are left out of the table, and in the views only their outline is drawn</source><translation>As rochas de menor largura visível b não estão na tabela, e nas vistas só o seu contorno é desenhado</translation></message>
<message><source>b at least</source><translation>b pelo menos</translation></message>
<message><source>Rocks with a confidence p below 0.85, which are hatched, are left out of the table, and in the views only their outline is drawn</source><translation>As rochas com confiança p menor que 0.85, hachuradas, não estão na tabela, e nas vistas só o seu contorno é desenhado</translation></message>
<message><source>%1 of %2 rocks</source><translation>%1 de %2 rochas</translation></message>
<message><source>, %1 of them uncertain (hatched)</source><translation>, %1 delas incertas (hachuradas)</translation></message>
<message><source>&amp;Shown Rocks (%1)…</source><translation>&amp;Rochas mostradas (%1)…</translation></message>
<message><source>&amp;All Rocks (%1)…</source><translation>&amp;Todas as rochas (%1)…</translation></message>
<message><source>fine</source><translation>fino</translation></message>
<message><source>coarse</source><translation>grosso</translation></message>
<message><source>%1, %2 of them uncertain (hatched); %3 pieces too small to be a rock</source><translation>%1, %2 delas incertas (hachuradas); %3 pedaços pequenos demais para ser uma rocha</translation></message>
<message><source>; %1 changed by hand</source><translation>; %1 alteradas à mão</translation></message>
<message><source>; %1 pieces outside the region of interest are left out</source><translation>; %1 pedaços fora da região de interesse ficam de fora</translation></message>
<message><source>A click selects a rock (Ctrl+click one more); the tool Pin (P) sets a target (Shift+click).</source><translation>Um clique escolhe uma rocha (Ctrl+clique mais uma); a ferramenta Fixar (P) fixa um alvo (Shift+clique).</translation></message>
<message><source>▲ %1 % over %2 m</source><translation>▲ %1 % acima de %2 m</translation></message>
<message><source>Visible width b by count: P20 %1, P50 %2, P80 %3 (20, 50, 80 % of the rocks are not wider), largest %4 m%5. Hidden parts make this finer than the pile is, by 40 % and more.</source><translation>Largura visível b por contagem: P20 %1, P50 %2, P80 %3 (20, 50, 80 % das rochas não são mais largas), a maior %4 m%5. As partes ocultas tornam isto mais fino do que a pilha, em 40 % e mais.</translation></message>
<message><source>Size curve</source><translation>Curva granulométrica</translation></message>
<message><source>Visible width b by count: 50 % of the rocks are not wider than P50. Hidden parts make this finer than the pile is, by 40 % and more.</source><translation>Largura visível b por contagem: 50 % das rochas não são mais largas que P50. As partes ocultas tornam isto mais fino do que a pilha, em 40 % e mais.</translation></message>
<message><source>%1 % of the rocks have a visible width of %2 m at most</source><translation>%1 % das rochas têm uma largura visível de no máximo %2 m</translation></message>
<message><source>no rocks to count</source><translation>nenhuma rocha a contar</translation></message>
<message><source>Export Section…</source><translation>Exportar a secção…</translation></message>
<message><source>Wheel: zoom; drag: move; two clicks: a length</source><translation>Roda: zoom; arrastar: mover; dois cliques: um comprimento</translation></message>
<message><source>Zoom in</source><translation>Aproximar</translation></message>
<message><source>Zoom out</source><translation>Afastar</translation></message>
<message><source>Fit</source><translation>Enquadrar</translation></message>
<message><source>Zoom to what the section is about</source><translation>Enquadrar aquilo de que trata a secção</translation></message>
<message><source>All</source><translation>Tudo</translation></message>
<message><source>Zoom to all points of the section</source><translation>Enquadrar todos os pontos da secção</translation></message>
<message><source>▲ This click is not on a line: click nearer to one.</source><translation>▲ Este clique não está numa linha: clique mais perto de uma.</translation></message>
<message><source>Click on the other end of the length.</source><translation>Clique na outra extremidade do comprimento.</translation></message>
<message><source>This length is stored with the measurements. Two more clicks measure another.</source><translation>Este comprimento está guardado com as medições. Mais dois cliques medem outro.</translation></message>
<message><source>Two clicks on the lines measure a length.</source><translation>Dois cliques nas linhas medem um comprimento.</translation></message>
<message><source>▲ %1 points are outside: All shows them.</source><translation>▲ %1 pontos estão fora: Tudo os mostra.</translation></message>
<message><source>Edge points, green: %1.</source><translation>Pontos de borda, em verde: %1.</translation></message>
<message><source>along the section [m]</source><translation>ao longo da secção [m]</translation></message>
<message><source>✕ INCOMPLETE</source><translation>✕ INCOMPLETO</translation></message>
<message><source>Open a scan…</source><translation>Abrir uma varredura…</translation></message>
<message><source>Connect to the scanner…</source><translation>Conectar ao scanner…</translation></message>
<message><source>Go on with the last session</source><translation>Seguir com a última sessão</translation></message>
<message><source>Demo draw-bell</source><translation>Sino de demonstração</translation></message>
<message><source>no scanner, no files needed</source><translation>sem scanner, sem arquivos</translation></message>
<message><source>Demo before and after a blast</source><translation>Demonstração antes e depois de um desmonte</translation></message>
<message><source>both, and what changed between them</source><translation>ambos, e o que mudou entre eles</translation></message>
<message><source>Recent</source><translation>Recentes</translation></message>
<message><source>Scans that were open are listed here.</source><translation>Aqui são listadas as varreduras que estiveram abertas.</translation></message>
<message><source>The edges of rocks in a laser range scan</source><translation>As bordas das rochas numa varredura laser de distâncias</translation></message>
<message><source>Reads raw grids, recordings (.mcap), ROS bags, PCD, PLY, E57, LAS, PTX, CSV, XYZ and others.</source><translation>Lê grades brutas, gravações (.mcap), bags do ROS, PCD, PLY, E57, LAS, PTX, CSV, XYZ e outros.</translation></message>
<message><source>EdgeScan sends only read requests and one subscription to the scanner.</source><translation>Envia ao scanner apenas leituras e uma assinatura.</translation></message>
<message><source>Cab mode</source><translation>Modo cabine</translation></message>
<message><source>a file on this computer or on a stick</source><translation>um arquivo deste computador ou de um pen drive</translation></message>
<message><source>Ctrl+O, or drop files anywhere in this window</source><translation>Ctrl+O, ou solte arquivos nesta janela</translation></message>
<message><source>a SICK LMS, or a robot with ROS as ws://ROBOT</source><translation>um SICK LMS, ou um robô com ROS como ws://ROBOT</translation></message>
<message><source>Ctrl+L; a SICK LMS, or a robot with ROS as ws://ROBOT</source><translation>Ctrl+L; um SICK LMS, ou um robô com ROS como ws://ROBOT</translation></message>
<message><source>✕ not found: it was moved, or its disk is missing. Locate…</source><translation>✕ não encontrado: foi movido, ou falta o disco. Localizar…</translation></message>
<message><source>there is none yet</source><translation>ainda não há nenhuma</translation></message>
<message><source>%1, %2, %3 UTC</source><translation>%1, %2, %3 UTC</translation></message>
<message><source>Open a scan or connect the scanner. The demo needs neither: it is a hung-up draw-bell.</source><translation>Abra uma varredura ou conecte o scanner. A demonstração não precisa de nenhum: é um sino bloqueado.</translation></message>
<message><source>Open the demo</source><translation>Abrir a demonstração</translation></message>
<message><source>Drag turns the cloud, the middle button moves it, the wheel zooms. A click marks a cell in cloud, range image and edge map; its card has distance and coordinates.</source><translation>Arrastar gira a nuvem, o botão do meio a move, a roda amplia. Um clique marca uma célula na nuvem, na imagem de distâncias e no mapa de bordas; sua ficha dá distância e coordenadas.</translation></message>
<message><source>View from the scanner</source><translation>Ver a partir do scanner</translation></message>
<message><source>Change Edge strength first. The curve under it shows the number of edge cells for every value. Where it is flat, the edges depend little on it.</source><translation>Ajuste primeiro a força das bordas. A curva abaixo mostra quantas bordas há para cada valor; onde ela é plana, as bordas dependem pouco do ajuste.</translation></message>
<message><source>Show the edges panel</source><translation>Mostrar o painel de bordas</translation></message>
<message><source>EdgeScan finds rocks from the edges, with visible sizes and a confidence. The table lists them. A click selects a rock in all views.</source><translation>O EdgeScan encontra as rochas a partir das bordas, com o tamanho visível e uma confiança. A tabela as lista. Um clique escolhe uma rocha em todas as vistas.</translation></message>
<message><source>Show the rocks</source><translation>Mostrar as rochas</translation></message>
<message><source>The tools above measure and compare scans. File exports edges, clouds and a report. Help shows all keys, and this tour again.</source><translation>As ferramentas acima medem e comparam varreduras. Arquivo exporta bordas, nuvens e um relatório. Ajuda mostra todas as teclas, e também este passeio.</translation></message>
<message><source>Show the keys</source><translation>Mostrar as teclas</translation></message>
<message><source>End the tour</source><translation>Encerrar o passeio</translation></message>
<message><source>was %1</source><translation>antes: %1</translation></message>
<message><source>Measure</source><translation>Medir</translation></message>
<message><source>Its name: keystone, left shoulder …</source><translation>O seu nome: pedra-chave, apoio esquerdo …</translation></message>
<message><source>Your note on it, stored with its name</source><translation>A sua nota sobre ele, guardada com o seu nome</translation></message>
<message><source>Lock</source><translation>Bloquear</translation></message>
<message><source>Locked: Del and Remove All do not remove it</source><translation>Bloqueado: Del e Remover todos não o removem</translation></message>
<message><source>Remove this target</source><translation>Remover este alvo</translation></message>
<message><source>Locked</source><translation>Bloqueado</translation></message>
<message><source>Target %1: %2</source><translation>Alvo %1: %2</translation></message>
<message><source>X, Y, Z</source><translation>X, Y, Z</translation></message>
<message><source>Metres in the frame of the scan</source><translation>Metros no sistema da varredura</translation></message>
<message><source>E, N, RL</source><translation>E, N, RL</translation></message>
<message><source>Easting, Northing and RL (height) in the mine grid, in metres</source><translation>Leste, norte e RL (altura) em coordenadas da mina, em metros</translation></message>
<message><source>Rock, visible</source><translation>Rocha, visível</translation></message>
<message><source>none here</source><translation>nenhuma aqui</translation></message>
<message><source>Length a and width b of its visible part. Hidden parts are not included.</source><translation>Comprimento a e largura b da sua parte visível. As partes escondidas não contam.</translation></message>
<message><source>Resolves</source><translation>Resolução</translation></message>
<message><source>The smallest thing seen reliably here: %1 to the next beam, and a beam of %2 as an LMS511 has it in high resolution</source><translation>A menor coisa vista de forma confiável aqui: %1 até o feixe vizinho, e um feixe de %2 como o de um LMS511 em alta resolução</translation></message>
<message><source>Surface</source><translation>Superfície</translation></message>
<message><source>Between its normal and the beam: 0° faces the scanner. A plane through %1 cells, relief %2</source><translation>Entre a sua normal e o feixe: 0° está de frente para o scanner. Um plano por %1 células, relevo %2</translation></message>
<message><source>Dip / direction</source><translation>Mergulho / direção</translation></message>
<message><source>Of the plane to the horizon, and clockwise from grid north the way it falls</source><translation>Do plano em relação ao horizonte, e no sentido horário a partir do norte da quadrícula, para onde ele cai</translation></message>
<message><source>From the boom</source><translation>Ao braço</translation></message>
<message><source>To the straight line from the boom's pivot to the head, where they were when this was measured; 0° off square: the boom points straight at the surface</source><translation>Até a reta do pivô do braço à cabeça, onde estavam na medição; 0°: o braço aponta de frente para a superfície</translation></message>
<message><source>line %1 · beam %2</source><translation>linha %1 · feixe %2</translation></message>
<message><source>Line angle %1°, beam angle %2°</source><translation>Ângulo da linha %1°, ângulo do feixe %2°</translation></message>
<message><source>, strength %1</source><translation>, força %1</translation></message>
<message><source>Edge</source><translation>Borda</translation></message>
<message><source>Strength 1 is at the threshold; Why says more</source><translation>A força 1 está no limiar; Por quê diz mais</translation></message>
<message><source>Share of nearby settings that find this edge too, computed after each change. It shows how much the edge depends on the settings, not whether a rock is there.</source><translation>Parte dos ajustes próximos que encontram também esta borda, calculada após cada alteração. Mostra quanto a borda depende dos ajustes, não se há ali uma rocha.</translation></message>
<message><source>large scan: show Edge Confidence</source><translation>varredura grande: mostre a confiança das bordas</translation></message>
<message><source>%1 m behind a jump where no edge is drawn (a slip of the stepper looks the same); measured on its near side</source><translation>%1 m atrás de um salto onde nenhuma aresta está desenhada (um deslize do motor de passo tem o mesmo aspecto); medido no seu lado próximo</translation></message>
<message><source>%1 m behind an edge; measured on its near side</source><translation>%1 m atrás de uma aresta; medido no seu lado próximo</translation></message>
<message><source>a beam between two surfaces; measured on the nearer one</source><translation>um feixe entre duas superfícies; medido na mais próxima</translation></message>
<message><source>one echo in front of all around it, as from dust; measured at the nearest cell behind it</source><translation>um só eco à frente de tudo à sua volta, como de poeira; medido na célula mais próxima atrás dele</translation></message>
<message><source>nothing was measured there; measured at the nearest cell</source><translation>nada foi medido aí; medido na célula mais próxima</translation></message>
<message><source>nothing was measured within %1 cells</source><translation>nada foi medido a menos de %1 células</translation></message>
<message><source>▲ a nearer surface is also within %1 cells: zoom in if that was meant</source><translation>▲ também há uma superfície mais próxima a menos de %1 células: amplie se era essa</translation></message>
<message><source>± not known</source><translation>± desconhecido</translation></message>
<message><source>E %1  N %2
RL %3 m</source><translation>E %1  N %2
RL %3 m</translation></message>
<message><source>x %1  y %2  z %3 m</source><translation>x %1  y %2  z %3 m</translation></message>
<message><source>E %1 N %2 RL %3</source><translation>E %1 N %2 RL %3</translation></message>
<message><source>Distance [m]</source><translation>Distância [m]</translation></message>
<message><source>Line</source><translation>Linha</translation></message>
<message><source>Beam</source><translation>Feixe</translation></message>
<message><source>Distance</source><translation>Distância</translation></message>
<message><source>Two standard deviations of the noise of this scan along the beam. Errors that the scanner makes everywhere are not included.</source><translation>Dois desvios padrão do ruído desta varredura ao longo do feixe. Os erros que o scanner comete em toda parte não estão incluídos.</translation></message>
<message><source>A click near an edge means its near side; with Shift it means the very cell</source><translation>Um clique perto de uma aresta refere-se ao seu lado próximo; com Shift, à própria célula</translation></message>
<message><source>from</source><translation>a partir de</translation></message>
<message><source>scanner, line of sight</source><translation>scanner, linha de visada</translation></message>
<message><source>Picture</source><translation>Imagem</translation></message>
<message><source>Confidence</source><translation>Confiança</translation></message>
<message><source>Copy All</source><translation>Copiar todos</translation></message>
<message><source>Remove All</source><translation>Remover todos</translation></message>
<message><source>The positions of all targets as a table with units, for a spreadsheet</source><translation>As posições de todos os alvos como tabela com unidades, para uma planilha</translation></message>
<message><source>All but those that are locked</source><translation>Todos menos os que estão bloqueados</translation></message>
<message><source>A vertical section through the selected measurement, or through the last one</source><translation>Uma secção vertical pela medição selecionada, ou pela última</translation></message>
<message><source>The selected measurement</source><translation>A medição escolhida</translation></message>
<message><source>Click a cell in any view to pin it.</source><translation>Clique em uma célula de qualquer vista para fixá-la.</translation></message>
<message><source>Number of edge cells at every threshold, from the least to the most on a logarithmic scale. Hatched: the widest range over which at most a fifth of them disappears. The vertical line is the threshold in use.</source><translation>Número de células de borda em cada limiar, do menor ao maior em escala logarítmica. Hachurado: o trecho mais largo em que desaparece no máximo um quinto delas. A linha vertical é o limiar em uso.</translation></message>
<message><source>counting the edge cells …</source><translation>contando as células de borda …</translation></message>
<message><source> · steady from %1 to %2</source><translation> · varia pouco de %1 a %2</translation></message>
<message><source>Without %1:</source><translation>Sem %1:</translation></message>
<message><source>Without %1 classes:</source><translation>Sem %1 classes:</translation></message>
<message><source>other classes take some of its cells, and chains get shorter: fewer edges, here and in files</source><translation>outras classes ficam com parte das suas células e as cadeias encurtam: menos bordas, aqui e nos arquivos</translation></message>
<message><source>Classes</source><translation>Classes</translation></message>
<message><source>How likely an edge is the border of a rock; where that is unknown, it is drawn like one.</source><translation>A probabilidade de uma borda ser o contorno de uma rocha; onde é desconhecida, desenha-se como um contorno.</translation></message>
<message><source>Without one class the other numbers change too: a cell has one class, and a weak cell counts where it continues a strong one of any class.</source><translation>Sem uma classe, os outros números também mudam: uma célula tem uma só classe, e uma célula fraca conta onde continua uma forte de qualquer classe.</translation></message>
<message><source>With a higher edge strength this number can rise: cells that were jumps or folds before count here.</source><translation>Com uma força da borda maior este número pode subir: as células que já não são saltos nem dobras contam aqui.</translation></message>
<message><source>Colours by class</source><translation>Cores por classe</translation></message>
<message><source>Each class in its own colour, or all edges in one: C</source><translation>Cada classe na sua cor, ou todas as bordas em uma só: C</translation></message>
<message><source>Rocks cover them in the cloud</source><translation>As rochas as cobrem na nuvem</translation></message>
<message><source>Rocks &gt; Edges over Rocks draws them over the rocks; the images show them.</source><translation>Rochas &gt; Bordas sobre as rochas as desenha por cima; as imagens as mostram.</translation></message>
<message><source>Striped green in the images; no beam measured these cells, and the cloud does not show them.</source><translation>Listrado de verde nas imagens; ninguém mediu estas células, e a nuvem não as mostra.</translation></message>
<message><source>Rock border, %1 % and more: %2</source><translation>Contorno de rocha, %1 % ou mais: %2</translation></message>
<message><source>Perhaps, %1 to 69 %: %2</source><translation>Talvez, %1 a 69 %: %2</translation></message>
<message><source>Fold in a rock, %1 to 29 %: %2</source><translation>Dobra numa rocha, %1 a 29 %: %2</translation></message>
<message><source>Fold in a rock, below 30 %: %1</source><translation>Dobra numa rocha, menos de 30 %: %1</translation></message>
<message><source>Violet stripes in the images: no return, outside of the range window, or masked. The status bar counts each.</source><translation>Listras violetas nas imagens: sem retorno, fora da janela de distâncias ou mascarado. A barra de status conta cada caso.</translation></message>
<message><source>Dark red stripes in the images: the scanner sent a status code in place of a range.</source><translation>Listras vermelho-escuras nas imagens: o scanner enviou um código de estado no lugar de uma distância.</translation></message>
<message><source>Laser ray to the marked cell</source><translation>Raio laser até a célula marcada</translation></message>
<message><source>No return: %1</source><translation>Sem retorno: %1</translation></message>
<message><source>No range: %1</source><translation>Sem distância: %1</translation></message>
<message><source>Status code: %1</source><translation>Código de estado: %1</translation></message>
<message><source>▥ Filled, not measured: %1</source><translation>▥ Preenchidas, não medidas: %1</translation></message>
<message><source>Edges, under rocks</source><translation>Bordas, sob as rochas</translation></message>
<message><source>Draws the edge points over the rocks</source><translation>Desenha os pontos de borda sobre as rochas</translation></message>
<message><source>Edge points on and off: E</source><translation>Pontos de borda visíveis ou não: E</translation></message>
<message><source>%1 mm at %2 m</source><translation>%1 mm a %2 m</translation></message>
<message><source>neighbours err alike, as in a depth camera</source><translation>os vizinhos erram juntos, como numa câmera de profundidade</translation></message>
<message><source>each cell errs for itself, in steps of the file</source><translation>cada célula erra por si, em passos do arquivo</translation></message>
<message><source>each cell errs for itself</source><translation>cada célula erra por si</translation></message>
<message><source>Noise in use: %1; sigma %2, %3, %4.</source><translation>Ruído em uso: %1; sigma %2, %3, %4.</translation></message>
<message><source>Folds have to exceed %1.</source><translation>As dobras têm de exceder %1.</translation></message>
<message><source>Rough scan: around half of the folds %1 % of the cells fold, so a fold must exceed its surroundings.</source><translation>Varredura rugosa: à volta de metade das dobras, %1 % das células dobram, por isso uma dobra tem de exceder o que a rodeia.</translation></message>
<message><source>Advanced</source><translation>Avançado</translation></message>
<message><source>Default</source><translation>Padrão</translation></message>
<message><source>For most scans of rock</source><translation>Para quase toda varredura</translation></message>
<message><source>Percent of range</source><translation>Porcentagem da distância</translation></message>
<message><source>Steps in percent of the range</source><translation>Saltos em % da distância</translation></message>
<message><source>Thesis</source><translation>Tese</translation></message>
<message><source>To compare with the thesis</source><translation>Para comparar com a tese</translation></message>
<message><source>Thesis, contrast</source><translation>Tese, contraste</translation></message>
<message><source>The thesis, with more contrast</source><translation>A tese, com mais contraste</translation></message>
<message><source>Smooth walls</source><translation>Paredes lisas</translation></message>
<message><source>For flat walls with low steps</source><translation>Paredes planas, saltos baixos</translation></message>
<message><source>Version 4</source><translation>Versão 4</translation></message>
<message><source>To compare with version 4</source><translation>Para comparar com a versão 4</translation></message>
<message><source>Version 3</source><translation>Versão 3</translation></message>
<message><source>To compare with version 3</source><translation>Para comparar com a versão 3</translation></message>
<message><source>Open…</source><translation>Abrir…</translation></message>
<message><source>Open a preset file</source><translation>Abrir um arquivo de predefinição</translation></message>
<message><source>Save…</source><translation>Salvar…</translation></message>
<message><source>Save these settings as a preset file</source><translation>Salvar estes ajustes como arquivo de predefinição</translation></message>
<message><source>Preset</source><translation>Predefinição</translation></message>
<message><source>The steps in depth that reach the thresholds, computed from the kernels: the smaller number for a step that runs diagonally, the larger one along lines or beams. A depth such as 0.5 m can be typed into the box above; with logarithmic gray levels it is taken at the range given here, and a share such as 5 % holds at every range.</source><translation>Os degraus de profundidade que atingem os limiares, calculados a partir dos kernels: o número menor para um degrau em diagonal, o maior para um ao longo de linhas ou feixes. No campo acima pode-se digitar uma profundidade como 0.5 m; com níveis de cinza logarítmicos ela é tomada à distância dada aqui, e uma proporção como 5 % vale a qualquer distância.</translation></message>
<message><source>Locked: the upper threshold is 3 times the lower one, as in the thesis. Click to open the lock.</source><translation>Bloqueado: o limiar superior é 3 vezes o inferior, como na tese. Clique para abrir o bloqueio.</translation></message>
<message><source>Locked 1 : 3</source><translation>Bloqueado 1 : 3</translation></message>
<message><source>Unlocked</source><translation>Desbloqueado</translation></message>
<message><source>Strong from  %1 % of range</source><translation>Forte a partir de  %1 % da distância</translation></message>
<message><source>Upper threshold  %1</source><translation>Limiar superior  %1</translation></message>
<message><source>  (no gradient reaches it)</source><translation>  (nenhum gradiente o atinge)</translation></message>
<message><source>• modified</source><translation>• modificado</translation></message>
<message><source>In files and on the command line its name is %1</source><translation>Nos arquivos e na linha de comando o nome é %1</translation></message>
<message><source>From a file</source><translation>De um arquivo</translation></message>
<message><source>computing …</source><translation>calculando …</translation></message>
<message><source>
%1 to %2 %3</source><translation>
%1 a %2 %3</translation></message>
<message><source>
Double-click: back to the preset</source><translation>
Clique duplo: voltar à predefinição</translation></message>
<message><source>less: %1</source><translation>menos: %1</translation></message>
<message><source>more: %1</source><translation>mais: %1</translation></message>
<message><source>More edges</source><translation>Mais bordas</translation></message>
<message><source>Fewer edges</source><translation>Menos bordas</translation></message>
<message><source>%1: %2; %3. The value stays as it was.</source><translation>%1: %2; %3. O valor fica como estava.</translation></message>
<message><source>auto</source><translation>auto</translation></message>
<message><source>Back to %1, the value of the preset</source><translation>Voltar a %1, o valor da predefinição</translation></message>
<message><source>Ends of the range window</source><translation>Extremos da janela de distâncias</translation></message>
<message><source>Drag an end, or Left and Right for the far one, with Shift for the near one; a double-click makes it automatic</source><translation>Arraste um extremo, ou Esquerda e Direita para o distante, com Shift para o próximo; um clique duplo a torna automática</translation></message>
<message><source>Gray</source><translation>Cinza</translation></message>
<message><source>Auto</source><translation>Auto</translation></message>
<message><source>Black and white as the method scales the ranges</source><translation>Preto e branco segundo a escala de distâncias do método</translation></message>
<message><source>The window stays as it is when another scan is opened</source><translation>A janela fica como está quando outra varredura é aberta</translation></message>
<message><source>%1 to %2 m</source><translation>de %1 a %2 m</translation></message>
<message><source>automatic: %1</source><translation>automático: %1</translation></message>
<message><source>filled, not measured: %1 m ± %2 m</source><translation>preenchida, não medida: %1 m ± %2 m</translation></message>
<message><source>range %1 m</source><translation>distância %1 m</translation></message>
<message><source>device status %1</source><translation>estado do equipamento %1</translation></message>
<message><source>E %1  N %2  RL %3</source><translation>E %1  N %2  RL %3</translation></message>
<message><source>EDGE</source><translation>BORDA</translation></message>
<message><source>not an edge</source><translation>não é uma borda</translation></message>
<message><source>line %1  beam %2</source><translation>linha %1  feixe %2</translation></message>
<message><source>  at %1° / %2°</source><translation>  a %1° / %2°</translation></message>
<message><source>  gray %1</source><translation>  cinza %1</translation></message>
<message><source>Without a pose, coordinates count from the scanner, not from the mine grid. Scan &gt; Pose and Mounting… takes one.</source><translation>Sem pose, as coordenadas contam a partir do scanner, não da grade da mina. Varredura &gt; Pose e montagem… recebe uma.</translation></message>
<message><source>Pinned:</source><translation>Fixado:</translation></message>
<message><source>Pinned nearby:</source><translation>Fixado perto:</translation></message>
<message><source>OUT OF SPEC</source><translation>FORA DE TOLERÂNCIA</translation></message>
<message><source> · origin E %1 N %2 RL %3</source><translation> · origem E %1 N %2 RL %3</translation></message>
<message><source>A click opens the pose, to change or remove it.</source><translation>Um clique abre a pose, para mudá-la ou removê-la.</translation></message>
<message><source>first line %1</source><translation>primeira linha %1</translation></message>
<message><source>%1 no return</source><translation>%1 sem retorno</translation></message>
<message><source> · %1 status</source><translation> · %1 estado do equipamento</translation></message>
<message><source> · %1 filled</source><translation> · %1 preenchidas</translation></message>
<message><source>Edges found in %1 ms</source><translation>Bordas encontradas em %1 ms</translation></message>
<message><source>%1 cells · edges pending</source><translation>%1 células · arestas pendentes</translation></message>
<message><source>edges pending</source><translation>arestas pendentes</translation></message>
<message><source>%1: %2 instead of %3</source><translation>%1: %2 em vez de %3</translation></message>
<message><source>default settings</source><translation>ajustes padrão</translation></message>
<message><source>settings: %1 changed</source><translation>ajustes: %1 modificado(s)</translation></message>
<message><source>%1 changed</source><translation>%1 modificado(s)</translation></message>
<message><source>Set of default settings: %1</source><translation>Conjunto de ajustes padrão: %1</translation></message>
<message><source>Reset %1</source><translation>Restaurar %1</translation></message>
<message><source>Reset all</source><translation>Restaurar tudo</translation></message>
<message><source>All settings are those of the default set.</source><translation>Todos os ajustes são os do conjunto padrão.</translation></message>
<message><source>Ctrl+D restores the default settings.</source><translation>Ctrl+D restaura os ajustes padrão.</translation></message>
<message><source>1 warning</source><translation>1 aviso</translation></message>
<message><source>Acknowledged.</source><translation>Vistos.</translation></message>
<message><source>Shows the warnings of this scan and acknowledges them. They remain in records and screenshots.</source><translation>Mostra os avisos desta varredura e os marca como vistos. Eles permanecem nos registros e nas capturas de tela.</translation></message>
<message><source>no scan open</source><translation>nenhuma varredura aberta</translation></message>
<message><source>no point to show: all %1 points are hidden; Measure &gt; Show All shows them</source><translation>nenhum ponto a mostrar: todos os %1 pontos estão ocultos; Medir &gt; Mostrar tudo os mostra</translation></message>
<message><source>no point to show: no cell of this scan has a valid range</source><translation>nenhum ponto a mostrar: nenhuma célula desta varredura tem uma distância válida</translation></message>
<message><source>There is no OpenGL on this display, so the 3D view cannot draw.</source><translation>Não há OpenGL nesta tela: a vista 3D não pode desenhar.</translation></message>
<message><source>OpenGL is installed but does not start on this display, so the 3D view cannot draw.</source><translation>O OpenGL está instalado mas não inicia nesta tela: a vista 3D não pode desenhar.</translation></message>
<message><source>The 3D view needs OpenGL 3.2; this display offers %1.%2 (%3).</source><translation>A vista 3D precisa de OpenGL 3.2; esta tela oferece %1.%2 (%3).</translation></message>
<message><source>The bar has this length at the median distance of the points in view. The distance counts from the scanner.</source><translation>A barra tem este comprimento na distância mediana dos pontos à vista. A distância conta a partir do scanner.</translation></message>
<message><source>grid %1</source><translation>grade %1</translation></message>
<message><source>%1 at %2 m</source><translation>%1 a %2 m</translation></message>
<message><source>Range [m]</source><translation>Distância [m]</translation></message>
<message><source>Height above the scanner [m]</source><translation>Altura sobre o scanner [m]</translation></message>
<message><source>Front</source><translation>Frente</translation></message>
<message><source>Left</source><translation>Esq.</translation></message>
<message><source>Right</source><translation>Dir.</translation></message>
<message><source>Top</source><translation>Topo</translation></message>
<message><source>Bottom</source><translation>Base</translation></message>
<message><source>Click a face: look at the cloud from there</source><translation>Clique numa face: olhar a nuvem dali</translation></message>
<message><source>Without a pose, up is the scanner's z</source><translation>Sem pose, acima é o eixo z do scanner</translation></message>
<message><source>Show the whole images</source><translation>Mostrar as imagens inteiras</translation></message>
<message><source>Zoomed %1 × · Fit</source><translation>Ampliado %1 × · Enquadrar</translation></message>
<message><source>Tune</source><translation>Ajustes</translation></message>
<message><source>Back to the cloud</source><translation>Voltar à nuvem</translation></message>
<message><source>Hold it for one second to leave.</source><translation>Segure um segundo para sair.</translation></message>
<message><source>No scan</source><translation>Nenhuma varredura</translation></message>
<message><source>Open one, or connect to a scanner</source><translation>Abra um, ou conecte um scanner</translation></message>
<message><source>%1 of %2 lines</source><translation>%1 de %2 linhas</translation></message>
<message><source> · %1 % no return</source><translation> · %1 % sem retorno</translation></message>
<message><source>Range image</source><translation>Imagem de distâncias</translation></message>
<message><source>Edge map</source><translation>Mapa de bordas</translation></message>
<message><source>Cloud</source><translation>Nuvem de pontos</translation></message>
<message><source>Small picture</source><translation>Imagem pequena</translation></message>
<message><source>Rock…</source><translation>Rocha…</translation></message>
<message><source>What can be done with rocks</source><translation>O que se pode fazer com as rochas</translation></message>
<message><source>Views</source><translation>Vistas</translation></message>
<message><source>Take the last point back</source><translation>Retirar o último ponto</translation></message>
<message><source>Targets</source><translation>Alvos</translation></message>
<message><source>Layers</source><translation>Camadas</translation></message>
<message><source>Rock Table</source><translation>Tabela de rochas</translation></message>
<message><source>Hide panel</source><translation>Ocultar painel</translation></message>
<message><source>turned by %1°</source><translation>giradas %1°</translation></message>
<message><source>mirrored</source><translation>espelhadas</translation></message>
<message><source>gray %1 to %2 m</source><translation>cinza %1 a %2 m</translation></message>
<message><source>up to line %1</source><translation>até a linha %1</translation></message>
<message><source>by class</source><translation>por classe</translation></message>
<message><source>growing</source><translation>a crescer</translation></message>
<message><source>%1 % of the points drawn</source><translation>%1 % dos pontos desenhados</translation></message>
<message><source>turntable</source><translation>mesa giratória</translation></message>
<message><source>free rotation</source><translation>rotação livre</translation></message>
<message><source>orthographic</source><translation>ortográfica</translation></message>
<message><source>perspective</source><translation>perspectiva</translation></message>
<message><source>coarse picture</source><translation>imagem grosseira</translation></message>
<message><source>Warnings of this scan:
</source><translation>Avisos desta varredura:
</translation></message>
<message><source>&amp;Legends at the Side</source><translation>&amp;Legendas ao lado</translation></message>
<message><source>view of the cloud</source><translation>vista da nuvem</translation></message>
<message><source>Letters outside a field are keys; these changed: %1.</source><translation>As letras fora de um campo são teclas; estas mudaram: %1.</translation></message>
<message><source>Opening another scan · still shown: </source><translation>Abrindo outra varredura · ainda na tela: </translation></message>
<message><source>The manual is not installed. Its texts are in the folder docs of the source, page %1.</source><translation>O manual não está instalado. Os seus textos estão na pasta docs do código-fonte, página %1.</translation></message>
<message><source>No browser opened the manual. It is the file %1.</source><translation>Nenhum navegador abriu o manual. É o ficheiro %1.</translation></message>
<message><source>Compare &amp;A/B</source><translation>Comparar &amp;A/B</translation></message>
<message><source>&amp;Keep This as A</source><translation>&amp;Guardar isto como A</translation></message>
<message><source>&amp;Compare with Earlier Scan…</source><translation>&amp;Comparar com uma varredura anterior…</translation></message>
<message><source>Exchange A and &amp;B</source><translation>Trocar A e &amp;B</translation></message>
<message><source>&amp;Demo before and after a Blast</source><translation>&amp;Demonstração antes e depois de um desmonte</translation></message>
<message><source>Show &amp;A</source><translation>Mostrar &amp;A</translation></message>
<message><source>Show What &amp;Changed</source><translation>Mostrar o que &amp;mudou</translation></message>
<message><source>&amp;Colour by Distance from A</source><translation>&amp;Cor conforme a distância a A</translation></message>
<message><source>&amp;Next Changed Region</source><translation>&amp;Próxima região alterada</translation></message>
<message><source>&amp;Previous Changed Region</source><translation>Região alterada a&amp;nterior</translation></message>
<message><source>&amp;Forget A</source><translation>&amp;Esquecer A</translation></message>
<message><source>Edge Con&amp;fidence</source><translation>Con&amp;fiança das bordas</translation></message>
<message><source>Colours and sizes of edges by how many settings near these find them too</source><translation>Cores e tamanhos das bordas conforme quantos ajustes próximos também as encontram</translation></message>
<message><source>“%1” has ended; a click selects a rock again.</source><translation>«%1» terminou; um clique volta a escolher uma rocha.</translation></message>
<message><source>“%1” has ended; a click pins again.</source><translation>«%1» terminou; um clique volta a fixar.</translation></message>
<message><source>&amp;Edges over Rocks</source><translation>Bor&amp;das sobre as rochas</translation></message>
<message><source>&amp;Rocks</source><translation>&amp;Rochas</translation></message>
<message><source>&amp;Show Rocks</source><translation>&amp;Mostrar rochas</translation></message>
<message><source>&amp;Largest Rock by Width b</source><translation>Rocha com a m&amp;aior largura b</translation></message>
<message><source>Next Sm&amp;aller Rock by Width b</source><translation>&amp;Próxima rocha com largura b menor</translation></message>
<message><source>&amp;Merge Rocks</source><translation>M&amp;esclar rochas</translation></message>
<message><source>S&amp;plit a Rock</source><translation>Di&amp;vidir uma rocha</translation></message>
<message><source>Merge al&amp;ong a Line</source><translation>Mesclar ao longo de &amp;uma linha</translation></message>
<message><source>C&amp;ut along a Line</source><translation>&amp;Cortar ao longo de uma linha</translation></message>
<message><source>&amp;Not a Rock, or a Rock Again</source><translation>&amp;Não é rocha, ou é sim</translation></message>
<message><source>Na&amp;me This Rock…</source><translation>No&amp;me desta rocha…</translation></message>
<message><source>&amp;Finer</source><translation>Mais &amp;fino</translation></message>
<message><source>&amp;Coarser</source><translation>Mais &amp;grosso</translation></message>
<message><source>Draw Region of &amp;Interest</source><translation>Desenhar a região de &amp;interesse</translation></message>
<message><source>Clear Re&amp;gion of Interest</source><translation>&amp;Limpar a região de interesse</translation></message>
<message><source>E&amp;xport Rocks…</source><translation>E&amp;xportar rochas…</translation></message>
<message><source>slope, grade and length of a straight line</source><translation>inclinação, declive e comprimento de uma reta</translation></message>
<message><source>&amp;Measure</source><translation>&amp;Medir</translation></message>
<message><source>&amp;Pin</source><translation>&amp;Fixar</translation></message>
<message><source>&amp;Distance</source><translation>&amp;Distância</translation></message>
<message><source>&amp;Vertical</source><translation>&amp;Vertical</translation></message>
<message><source>&amp;Angle</source><translation>Â&amp;ngulo</translation></message>
<message><source>&amp;Spans a × b</source><translation>&amp;Extensões a × b</translation></message>
<message><source>Along S&amp;urface</source><translation>Ao longo da &amp;superfície</translation></message>
<message><source>Thr&amp;oat Width</source><translation>Largura da &amp;garganta</translation></message>
<message><source>Se&amp;ction through the Measurement</source><translation>Se&amp;cção pela medição</translation></message>
<message><source>Section th&amp;rough the Rock</source><translation>Secção pela &amp;rocha</translation></message>
<message><source>&amp;Box</source><translation>Cai&amp;xa</translation></message>
<message><source>&amp;Lasso</source><translation>&amp;Laço</translation></message>
<message><source>Na&amp;me This Target</source><translation>Nome&amp;ar este alvo</translation></message>
<message><source>Remove This Tar&amp;get</source><translation>&amp;Remover este alvo</translation></message>
<message><source>Remove All &amp;Targets</source><translation>Remover &amp;todos os alvos</translation></message>
<message><source>&amp;Copy This Target</source><translation>&amp;Copiar este alvo</translation></message>
<message><source>Sho&amp;w All</source><translation>&amp;Mostrar tudo</translation></message>
<message><source>Clip to Bo&amp;x round Selected</source><translation>Recortar a uma &amp;caixa em torno da seleção</translation></message>
<message><source>&amp;Range Gate…</source><translation>&amp;Janela de distância…</translation></message>
<message><source>Hide &amp;Farther than This Cell</source><translation>Ocultar o que está mais &amp;longe que esta célula</translation></message>
<message><source>Hide Nearer than This Cell</source><translation>Ocultar o que está mais perto que esta célula</translation></message>
<message><source>&amp;Zoom to Selected</source><translation>&amp;Zoom na seleção</translation></message>
<message><source>Select &amp;Nothing</source><translation>Não seleciona&amp;r nada</translation></message>
<message><source>There are no targets yet: pin a cell first.</source><translation>Ainda não há alvos: fixe primeiro uma célula.</translation></message>
<message><source>Edge &amp;Drawing (DXF)…</source><translation>&amp;Desenho das bordas (DXF)…</translation></message>
<message><source>&amp;Selected Cells…</source><translation>Células &amp;selecionadas…</translation></message>
<message><source>Open &amp;Recent</source><translation>Abrir &amp;recente</translation></message>
<message><source>&amp;File</source><translation>&amp;Arquivo</translation></message>
<message><source>&amp;Open…</source><translation>&amp;Abrir…</translation></message>
<message><source>Open &amp;Demo Draw-Bell</source><translation>Abrir o sino de &amp;demonstração</translation></message>
<message><source>Demo before and after a &amp;Blast</source><translation>Demo antes e depois de um &amp;desmonte</translation></message>
<message><source>&amp;Connect to Scanner…</source><translation>&amp;Conectar ao scanner…</translation></message>
<message><source>Re&amp;load</source><translation>Recarre&amp;gar</translation></message>
<message><source>&amp;Export</source><translation>&amp;Exportar</translation></message>
<message><source>Re&amp;port…</source><translation>Re&amp;latório…</translation></message>
<message><source>&amp;Screenshot…</source><translation>Captura de &amp;tela…</translation></message>
<message><source>&amp;Copy as Command</source><translation>Copiar como co&amp;mando</translation></message>
<message><source>&amp;Quit</source><translation>&amp;Sair</translation></message>
<message><source>&amp;Undo</source><translation>&amp;Desfazer</translation></message>
<message><source>&amp;Redo</source><translation>&amp;Refazer</translation></message>
<message><source>&amp;Edit</source><translation>&amp;Editar</translation></message>
<message><source>&amp;Copy Probe Values</source><translation>&amp;Copiar valores sob o cursor</translation></message>
<message><source>&amp;Edge Points</source><translation>&amp;Pontos de borda</translation></message>
<message><source>Edges &amp;by Class</source><translation>Bordas por &amp;classe</translation></message>
<message><source>Edges &amp;over Range Image</source><translation>Bordas so&amp;bre a imagem de distâncias</translation></message>
<message><source>&amp;Colour-Blind Edge Colours</source><translation>Cores de borda para dal&amp;tônicos</translation></message>
<message><source>I&amp;mages</source><translation>I&amp;magens</translation></message>
<message><source>True &amp;Angle Aspect</source><translation>Proporção an&amp;gular real</translation></message>
<message><source>Turn by a &amp;Quarter</source><translation>Girar um &amp;quarto à direita</translation></message>
<message><source>Turn by a &amp;Half</source><translation>Dar &amp;meia volta</translation></message>
<message><source>&amp;Mirror</source><translation>&amp;Espelhar</translation></message>
<message><source>Loo&amp;k from</source><translation>&amp;Olhar de</translation></message>
<message><source>From &amp;Scanner</source><translation>A partir do s&amp;canner</translation></message>
<message><source>&amp;Front</source><translation>De &amp;frente</translation></message>
<message><source>&amp;Back</source><translation>De &amp;trás</translation></message>
<message><source>&amp;Right</source><translation>&amp;Direita</translation></message>
<message><source>&amp;Left</source><translation>&amp;Esquerda</translation></message>
<message><source>&amp;Top (from Above)</source><translation>De &amp;cima</translation></message>
<message><source>Botto&amp;m (from Below)</source><translation>De &amp;baixo</translation></message>
<message><source>&amp;Isometric</source><translation>&amp;Isométrica</translation></message>
<message><source>Sto&amp;red Views</source><translation>&amp;Vistas salvas</translation></message>
<message><source>View &amp;%1</source><translation>Vista &amp;%1</translation></message>
<message><source>Store as View &amp;%1</source><translation>Salvar como vista &amp;%1</translation></message>
<message><source>Clou&amp;d</source><translation>&amp;Nuvem de pontos</translation></message>
<message><source>&amp;Orthographic</source><translation>&amp;Ortográfica</translation></message>
<message><source>T&amp;urntable</source><translation>Mesa &amp;giratória</translation></message>
<message><source>&amp;Dim Cloud under Edges</source><translation>Ate&amp;nuar a nuvem sob as bordas</translation></message>
<message><source>Depth S&amp;hading</source><translation>&amp;Sombreamento por profundidade</translation></message>
<message><source>&amp;Ground Grid</source><translation>&amp;Grade do chão</translation></message>
<message><source>Vie&amp;w Cube</source><translation>&amp;Cubo de vistas</translation></message>
<message><source>Point Size &amp;+</source><translation>Tamanho dos pontos &amp;+</translation></message>
<message><source>Point Size &amp;-</source><translation>Tamanho dos pontos &amp;-</translation></message>
<message><source>Point Size by &amp;Spacing</source><translation>Tamanho dos pontos pelo e&amp;spaçamento</translation></message>
<message><source>&amp;Panels</source><translation>&amp;Painéis</translation></message>
<message><source>&amp;View</source><translation>E&amp;xibir</translation></message>
<message><source>Fit All Vi&amp;ews</source><translation>&amp;Enquadrar todas as vistas</translation></message>
<message><source>&amp;Zoom In</source><translation>&amp;Aproximar</translation></message>
<message><source>Zoom O&amp;ut</source><translation>A&amp;fastar</translation></message>
<message><source>Fl&amp;y to Point under Cursor</source><translation>&amp;Voar até o ponto sob o cursor</translation></message>
<message><source>Reset &amp;Layout</source><translation>Restaurar o &amp;layout</translation></message>
<message><source>Full Scree&amp;n</source><translation>Te&amp;la cheia</translation></message>
<message><source>P&amp;ose and Mounting…</source><translation>Pose e mo&amp;ntagem…</translation></message>
<message><source>&amp;Scan</source><translation>&amp;Varredura</translation></message>
<message><source>&amp;Next Scan</source><translation>&amp;Próxima varredura</translation></message>
<message><source>Pre&amp;vious Scan</source><translation>Varredura &amp;anterior</translation></message>
<message><source>&amp;Add a Scan as a Layer…</source><translation>&amp;Adicionar varredura como camada…</translation></message>
<message><source>&amp;Record</source><translation>&amp;Gravar</translation></message>
<message><source>&amp;Keep Last Minute</source><translation>&amp;Conservar o último minuto</translation></message>
<message><source>S&amp;weep…</source><translation>V&amp;arredura…</translation></message>
<message><source>&amp;Hold First Sweep of a Connection at Its End</source><translation>Co&amp;ngelar a primeira varredura de uma conexão no fim</translation></message>
<message><source>Recordings &amp;Folder…</source><translation>Pasta das gra&amp;vações…</translation></message>
<message><source>P&amp;lay or Pause</source><translation>&amp;Reproduzir ou pausar</translation></message>
<message><source>Next Line</source><translation>Próxima linha</translation></message>
<message><source>Previous Line</source><translation>Linha anterior</translation></message>
<message><source>Ten Lines Forward</source><translation>Dez linhas adiante</translation></message>
<message><source>Ten Lines Back</source><translation>Dez linhas atrás</translation></message>
<message><source>&amp;Straighten Beams</source><translation>&amp;Endireitar os feixes</translation></message>
<message><source>Keep Repeate&amp;d Values</source><translation>Manter os valores repeti&amp;dos</translation></message>
<message><source>&amp;How the Scan Is Read…</source><translation>Co&amp;mo a varredura é lida…</translation></message>
<message><source>Does This Look &amp;Right?</source><translation>Pa&amp;rece correto?</translation></message>
<message><source>&amp;Properties…</source><translation>Proprie&amp;dades…</translation></message>
<message><source>&amp;Presets</source><translation>&amp;Predefinições</translation></message>
<message><source>&amp;Save…</source><translation>&amp;Salvar…</translation></message>
<message><source>&amp;Edges</source><translation>&amp;Bordas</translation></message>
<message><source>&amp;Lock upper = 3 × lower</source><translation>&amp;Bloquear superior = 3 × inferior</translation></message>
<message><source>&amp;Only Rock Borders</source><translation>S&amp;ó contornos de rocha</translation></message>
<message><source>This &amp;Is an Edge</source><translation>Isto &amp;é uma borda</translation></message>
<message><source>This Is &amp;Not an Edge</source><translation>Isto &amp;não é uma borda</translation></message>
<message><source>Settings for These &amp;Marks…</source><translation>Ajustes para estas &amp;marcas…</translation></message>
<message><source>Clear the Mar&amp;ks</source><translation>Limpar as mar&amp;cas</translation></message>
<message><source>&amp;Why Is This Cell an Edge or Not?</source><translation>Por &amp;que esta célula é uma borda, ou não?</translation></message>
<message><source>&amp;Reset to Preset</source><translation>&amp;Voltar à predefinição</translation></message>
<message><source>Restore the &amp;Default Settings</source><translation>Restaurar os ajustes pa&amp;drão</translation></message>
<message><source>&amp;Help</source><translation>Aj&amp;uda</translation></message>
<message><source>&amp;Find a Command…</source><translation>&amp;Localizar um comando…</translation></message>
<message><source>&amp;Manual</source><translation>&amp;Manual</translation></message>
<message><source>&amp;Keys and Mouse</source><translation>&amp;Teclado e mouse</translation></message>
<message><source>&amp;Tour</source><translation>&amp;Passeio</translation></message>
<message><source>&amp;About EdgeScan</source><translation>&amp;Sobre o EdgeScan</translation></message>
<message><source>Open Sess&amp;ion…</source><translation>Abrir sess&amp;ão…</translation></message>
<message><source>&amp;Save Session As…</source><translation>&amp;Salvar sessão como…</translation></message>
<message><source>Go on with the &amp;Last Session</source><translation>Continuar a ú&amp;ltima sessão</translation></message>
<message><source>Tools</source><translation>Ferramentas</translation></message>
<message><source>Pin</source><translation>Fixar</translation></message>
<message><source>Scanner view</source><translation>Vista scanner</translation></message>
<message><source>Cab</source><translation>Cabine</translation></message>
<message><source>A/B</source><translation>A/B</translation></message>
<message><source>&amp;Theme</source><translation>&amp;Tema</translation></message>
<message><source>Lan&amp;guage</source><translation>Id&amp;ioma</translation></message>
<message><source>The window uses this language from the next start on.</source><translation>A janela fala este idioma a partir do seu próximo início.</translation></message>
<message><source>Restart Now</source><translation>Reiniciar agora</translation></message>
<message><source>&amp;Mouse</source><translation>Mo&amp;use</translation></message>
<message><source>&amp;Default: middle pans, right zooms</source><translation>&amp;Padrão: o do meio desloca, o direito aproxima e afasta</translation></message>
<message><source>&amp;CloudCompare: right pans, middle zooms</source><translation>&amp;CloudCompare: o direito desloca, o do meio aproxima e afasta</translation></message>
<message><source>&amp;Wheel the other way</source><translation>&amp;Roda no sentido inverso</translation></message>
<message><source>By &amp;Intensity</source><translation>Por &amp;intensidade</translation></message>
<message><source>By &amp;Intensity (this scan has none)</source><translation>Por &amp;intensidade (esta varredura não tem)</translation></message>
<message><source>Cloud C&amp;olour</source><translation>C&amp;or da nuvem</translation></message>
<message><source>G&amp;ray</source><translation>&amp;Cinza</translation></message>
<message><source>By &amp;Range</source><translation>Por &amp;distância</translation></message>
<message><source>By &amp;Height</source><translation>Por &amp;altura</translation></message>
<message><source>By &amp;Line</source><translation>Por &amp;linha</translation></message>
<message><source>&amp;Sizes of Views</source><translation>&amp;Tamanhos das vistas</translation></message>
<message><source>&amp;Next Sizes of Views</source><translation>&amp;Próximos tamanhos das vistas</translation></message>
<message><source>&amp;Balanced</source><translation>&amp;Equilibrado</translation></message>
<message><source>&amp;Images Large</source><translation>&amp;Imagens grandes</translation></message>
<message><source>&amp;Cloud Large</source><translation>&amp;Nuvem grande</translation></message>
<message><source>C&amp;ab Mode</source><translation>Modo c&amp;abine</translation></message>
<message><source>Next Sweep</source><translation>Varredura seguinte</translation></message>
<message><source>Undo brings %1 back with its targets and measurements: the next sweep replaced it.</source><translation>Desfazer traz %1 de volta com os seus alvos e medições: a varredura seguinte a substituiu.</translation></message>
<message><source>%1 is no longer compared as A, because it may be of another place. Undo (Ctrl+Z) brings it back.</source><translation>%1 já não é comparado como A, porque pode ser de outro lugar. Desfazer (Ctrl+Z) recupera-o.</translation></message>
<message><source>The window has no room for the images next to this panel: they come back when you fold it.</source><translation>A janela não tem espaço para as imagens ao lado deste painel: elas voltam quando você o recolhe.</translation></message>
<message><source>Close EdgeScan?</source><translation>Fechar o EdgeScan?</translation></message>
<message><source>A recording is being written.</source><translation>Uma gravação está sendo escrita.</translation></message>
<message><source>A file is still being written.</source><translation>Um arquivo ainda está sendo escrito.</translation></message>
<message><source>Your targets and your edits of rocks are not stored.</source><translation>Seus alvos e suas edições de rochas não estão guardados.</translation></message>
<message><source>Your targets are not stored.</source><translation>Seus alvos não estão guardados.</translation></message>
<message><source>Your edits of rocks are not stored.</source><translation>Suas edições de rochas não estão guardadas.</translation></message>
<message><source>This ends the program.</source><translation>Isto termina o programa.</translation></message>
<message><source>Closing ends the recording. What was recorded so far remains in its file.</source><translation>Ao fechar, a gravação termina. O que foi gravado até agora fica no seu arquivo.</translation></message>
<message><source>Closing waits until it is complete.</source><translation>O fechamento espera até que ele esteja completo.</translation></message>
<message><source>The disk refused them. EdgeScan tries again as it closes; what it cannot write then is lost.</source><translation>O disco os recusou. O EdgeScan tenta de novo ao fechar; o que então não puder gravar se perde.</translation></message>
<message><source>To leave cab mode only, cancel, then hold the button “Hold to leave” for one second.</source><translation>Para sair só do modo cabine, cancele e segure um segundo o botão “Segurar: sair”.</translation></message>
<message><source>End the Recording and Close</source><translation>Encerrar a gravação e fechar</translation></message>
<message><source>Close EdgeScan</source><translation>Fechar o EdgeScan</translation></message>
<message><source>The tour has ended; Help &gt; Tour begins it again.</source><translation>O passeio terminou; Ajuda &gt; Passeio começa-o de novo.</translation></message>
<message><source>Drawing with edge lines</source><translation>Desenho com as linhas das bordas</translation></message>
<message><source>E57</source><translation>E57</translation></message>
<message><source>Range picture</source><translation>Imagem de distâncias</translation></message>
<message><source>LAS point cloud</source><translation>Nuvem de pontos LAS</translation></message>
<message><source>numpy array</source><translation>Matriz numpy</translation></message>
<message><source>Wavefront OBJ</source><translation>OBJ da Wavefront</translation></message>
<message><source>Point Cloud Library</source><translation>Point Cloud Library (PCL)</translation></message>
<message><source>Polygon file</source><translation>Arquivo de polígonos</translation></message>
<message><source>Point list</source><translation>Lista de pontos</translation></message>
<message><source>Point table</source><translation>Tabela de pontos</translation></message>
<message><source>3DTK scan</source><translation>Varredura 3DTK</translation></message>
<message><source>Leica PTX</source><translation>Leica PTX</translation></message>
<message><source>Range or point table</source><translation>Tabela de distâncias ou de pontos</translation></message>
<message><source>Raw grid</source><translation>Grade bruta</translation></message>
<message><source>Recording</source><translation>Gravação</translation></message>
<message><source>How edges are found: jumps and folds of the surface, parts of these, or Canny on gray levels as in the thesis, or one of the other detectors the thesis compares.</source><translation>Como as bordas são encontradas: saltos e dobras da superfície, partes destes, ou Canny em níveis de cinza como na tese, ou um dos outros detectores que a tese compara.</translation></message>
<message><source>Edges shown</source><translation>Bordas mostradas</translation></message>
<message><source>Only edges that are likely the border of a rock are shown and exported; folds within a rock are left out.</source><translation>Só se mostram e exportam as bordas que provavelmente são o contorno de uma rocha; as dobras dentro de uma rocha ficam de fora.</translation></message>
<message><source>Border from</source><translation>Contorno desde</translation></message>
<message><source>How likely an edge must be the border of a rock to be shown among the rock borders.</source><translation>A probabilidade de uma borda ser o contorno de uma rocha, a partir da qual se mostra entre os contornos de rochas.</translation></message>
<message><source>Edge strength</source><translation>Força da borda</translation></message>
<message><source>How strong an edge must be, so higher finds fewer: 1 is the jump and the crease angle below, 2 is twice that.</source><translation>Que força uma borda deve ter (mais força, menos bordas): 1 é o salto e o ângulo de dobra abaixo, 2 é o dobro.</translation></message>
<message><source>Jump</source><translation>Salto</translation></message>
<message><source>Smallest step in depth that is an edge, near the scanner; auto takes 30 mm and more where the ranges are noisy.</source><translation>Menor degrau de profundidade que é uma borda, perto do scanner; auto toma 30 mm, e mais onde as distâncias têm ruído.</translation></message>
<message><source>Jump growth</source><translation>Crescimento do salto</translation></message>
<message><source>% of range</source><translation>% dist.</translation></message>
<message><source>What the smallest step grows by with the distance.</source><translation>Quanto o menor degrau cresce com a distância.</translation></message>
<message><source>Crease angle</source><translation>Ângulo de dobra</translation></message>
<message><source>Smallest fold of the surface that is an edge.</source><translation>Menor dobra da superfície que é uma borda.</translation></message>
<message><source>Minimum length</source><translation>Comprimento mínimo</translation></message>
<message><source>Shorter chains of edge cells are dropped. At a void each class is chained by itself: a rim in two classes is two chains.</source><translation>As cadeias mais curtas de células de borda são descartadas. Num vazio, cada classe forma as suas próprias cadeias: uma borda em duas classes são duas cadeias.</translation></message>
<message><source>Which edges count: jumps in depth, convex folds (ridges), concave folds (contacts between rocks), the near side of a void with something farther behind it, and the rim of an open void; and where the data end, which is not an edge.</source><translation>Quais bordas contam: saltos de profundidade, dobras convexas (cristas), dobras côncavas (contatos entre rochas), o lado próximo de um vazio com algo mais longe atrás e a beira de um vazio aberto; e, o que não é borda, onde os dados terminam.</translation></message>
<message><source>Hysteresis low</source><translation>Histerese, limiar baixo</translation></message>
<message><source>% of high</source><translation>% do alto</translation></message>
<message><source>Weaker cells of this strength are edges where they continue a strong one.</source><translation>As células mais fracas, desta força, são bordas onde continuam uma forte.</translation></message>
<message><source>Grazing tolerance</source><translation>Tolerância rasante</translation></message>
<message><source>steps</source><translation>passos</translation></message>
<message><source>How far out of place a beam may be before a grazing surface shows a jump: 0.1 for a motor sweep, 1 for interlaced beams.</source><translation>Quanto um feixe pode estar fora do lugar antes que uma superfície rasante mostre um salto: 0.1 para uma varredura motorizada, 1 para feixes entrelaçados.</translation></message>
<message><source>Allow for slips</source><translation>Levar em conta os escorregamentos</translation></message>
<message><source>Beams interlaced from two passes and lines at which the stepper slipped are recognised and taken into account.</source><translation>Os feixes entrelaçados de duas passagens e as linhas em que o motor de passo escorregou são reconhecidos e levados em conta.</translation></message>
<message><source>Allow for turns</source><translation>Considerar os recuos</translation></message>
<message><source>At the first and last lines of a sweep a stepper may still swing back, so that every surface seems to fold there; such folds are left out.</source><translation>Nas primeiras e últimas linhas de uma varredura, o motor pode ainda recuar, e toda a superfície parece dobrar ali; essas dobras são deixadas de fora.</translation></message>
<message><source>Range noise at 5 m</source><translation>Ruído de distância a 5 m</translation></message>
<message><source>Sigma of the ranges at 5 m; auto measures it in the scan.</source><translation>Sigma das distâncias a 5 m; auto o mede na varredura.</translation></message>
<message><source>Noise from cell to cell</source><translation>Ruído de célula a célula</translation></message>
<message><source>Whether each cell errs for itself, as with a laser, or neighbours err alike, as with a depth camera whose depth comes in steps: folds then have to exceed what such steps look like.</source><translation>Se cada célula erra por si, como com um laser, ou se as vizinhas erram juntas, como com uma câmara de profundidade cuja profundidade vem em degraus: as dobras têm então de exceder o que tais degraus parecem.</translation></message>
<message><source>Rules</source><translation>Regras</translation></message>
<message><source>How noise is measured and where the rim of a void ends: as today, or as in default set 4, which also has a rule for rough scans.</source><translation>Como se mede o ruído e onde acaba a beira de um vazio: como hoje, ou como no conjunto padrão 4, que tem também uma regra para varreduras rugosas.</translation></message>
<message><source>Rough scans</source><translation>Varreduras rugosas</translation></message>
<message><source>Only by the rules of default set 4. Where half of the folds are on surfaces that fold everywhere, such as heaps of small boulders, a fold counts only if it exceeds its surroundings.</source><translation>Só pelas regras do conjunto padrão 4. Onde metade das dobras está em superfícies que dobram por toda a parte, como montes de pedras pequenas, uma dobra só conta se exceder o que a rodeia.</translation></message>
<message><source>Fill gaps</source><translation>Preencher lacunas</translation></message>
<message><source>Gaps up to this width are filled from their surroundings, never across a jump. Filled cells are marked and never count as measured. 0 switches filling off.</source><translation>As lacunas de até esta largura são preenchidas com o que as cerca, nunca sobre um salto; as células preenchidas são marcadas e não contam como medidas. 0 não preenche nenhuma.</translation></message>
<message><source>Edges in gaps</source><translation>Bordas em lacunas</translation></message>
<message><source>Filled cells take part in finding edges, and may be edges that no beam measured.</source><translation>As células preenchidas participam da busca de bordas, e podem ser bordas que ninguém mediu.</translation></message>
<message><source>Lower threshold</source><translation>Limiar inferior</translation></message>
<message><source>levels</source><translation>níveis</translation></message>
<message><source>A cell with a gradient above this is an edge: with Canny if a chain of such cells leads to a strong one, with detectors of one threshold always.</source><translation>Uma célula com gradiente acima deste é uma borda: com Canny se uma cadeia de tais células leva a uma forte, com os detectores de um limiar sempre.</translation></message>
<message><source>Step</source><translation>Degrau</translation></message>
<message><source>A straight step of this share of the range is a weak edge, one of about ratio times that a strong one.</source><translation>Um degrau reto desta proporção da distância é uma borda fraca, um de cerca da razão vezes isso é uma forte.</translation></message>
<message><source>Ratio upper : lower</source><translation>Razão superior : inferior</translation></message>
<message><source>Upper threshold as a multiple of the lower one; the thesis keeps 3.</source><translation>Limiar superior como múltiplo do inferior; a tese mantém 3.</translation></message>
<message><source>Gaussian kernel</source><translation>Kernel gaussiano</translation></message>
<message><source>Size of the smoothing kernel; 1 switches smoothing off.</source><translation>Tamanho do kernel de suavização; 1 desliga a suavização.</translation></message>
<message><source>Gaussian sigma</source><translation>Sigma gaussiano</translation></message>
<message><source>Width of the smoothing; auto takes it from the kernel size.</source><translation>Largura da suavização; auto a toma do tamanho do kernel.</translation></message>
<message><source>Gray scaling</source><translation>Escala de cinza</translation></message>
<message><source>How ranges become gray levels: as the thesis prints it, evenly from near to far, or by equal ratios from near to far.</source><translation>Como as distâncias viram níveis de cinza: como a tese imprime, uniformemente de perto a longe, ou por razões iguais de perto a longe.</translation></message>
<message><source>Near</source><translation>Perto</translation></message>
<message><source>Range drawn as gray 0; auto takes it from the scan. Not used by thesis scaling.</source><translation>Distância desenhada como cinza 0; auto a toma da varredura. Não usada pela escala da tese.</translation></message>
<message><source>Far</source><translation>Longe</translation></message>
<message><source>Range drawn as gray 255; auto takes it from the scan. Not used by thesis scaling.</source><translation>Distância desenhada como cinza 255; auto a toma da varredura. Não usada pela escala da tese.</translation></message>
<message><source>Mask missing data</source><translation>Mascarar dados ausentes</translation></message>
<message><source>Keeps cells without a range out of smoothing and gradient, so that the border of a hole is not an edge.</source><translation>Deixa as células sem distância fora da suavização e do gradiente, para que o limite de um buraco não seja uma borda.</translation></message>
<message><source>Mask isolated cells</source><translation>Mascarar células isoladas</translation></message>
<message><source>With missing data masked: a cell that fewer than 2 of its 8 neighbours agree with (dust) counts as missing.</source><translation>Com os dados ausentes mascarados: uma célula com a qual concordam menos de 2 das suas 8 vizinhas (poeira) conta como ausente.</translation></message>
<message><source>Sobel aperture</source><translation>Abertura de Sobel</translation></message>
<message><source>Size of the gradient operator; larger ones need thresholds many times higher.</source><translation>Tamanho do operador de gradiente; os maiores precisam de limiares muitas vezes mais altos.</translation></message>
<message><source>Gradient norm</source><translation>Norma do gradiente</translation></message>
<message><source>How the two gradient components become one magnitude.</source><translation>Como as duas componentes do gradiente viram uma magnitude.</translation></message>
<message><source>Laplacian mask</source><translation>Máscara do laplaciano</translation></message>
<message><source>Which mask approximates the Laplacian of Gaussian.</source><translation>Qual máscara representa o laplaciano de gaussiana.</translation></message>
<message><source>All edges</source><translation>Todas</translation></message>
<message><source>Rock borders</source><translation>De rochas</translation></message>
<message><source>Even</source><translation>Uniforme</translation></message>
<message><source>Logarithmic</source><translation>Logarítmica</translation></message>
<message><source>1 (off)</source><translation>1 (desligado)</translation></message>
<message><source>L1  |gx| + |gy|</source><translation>L1  |gx| + |gy|</translation></message>
<message><source>L2  sqrt(gx² + gy²)</source><translation>L2 √(gx² + gy²)</translation></message>
<message><source>4 neighbours</source><translation>4 vizinhas</translation></message>
<message><source>8 neighbours</source><translation>8 vizinhas</translation></message>
<message><source>of default set 4</source><translation>do conjunto 4</translation></message>
<message><source>of today</source><translation>de hoje</translation></message>
<message><source>as measured</source><translation>conforme medido</translation></message>
<message><source>laser</source><translation>laser</translation></message>
<message><source>depth camera</source><translation>câmara 3D</translation></message>
<message><source>EdgeScan+</source><translation>EdgeScan+</translation></message>
<message><source>Rock outlines</source><translation>Contornos de rochas</translation></message>
<message><source>Jumps</source><translation>Saltos</translation></message>
<message><source>Canny (thesis)</source><translation>Canny (tese)</translation></message>
<message><source>Canny on log range</source><translation>Canny, log(distância)</translation></message>
<message><source>Roberts</source><translation>Roberts</translation></message>
<message><source>Sobel</source><translation>Sobel</translation></message>
<message><source>Prewitt</source><translation>Prewitt</translation></message>
<message><source>Kirsch</source><translation>Kirsch</translation></message>
<message><source>Robinson</source><translation>Robinson</translation></message>
<message><source>Marr-Hildreth</source><translation>Marr-Hildreth</translation></message>
<message><source>Laplacian (LoG)</source><translation>Laplaciano (LoG)</translation></message>
<message><source>EdgeScan+: jumps in depth and folds of the surface, with thresholds that follow the noise of the scan.</source><translation>EdgeScan+: saltos de profundidade e dobras da superfície, com limiares que seguem o ruído da varredura.</translation></message>
<message><source>Canny on logarithmic gray levels, so that a step counts in percent of its range; missing data masked, so that a hole has no edge.</source><translation>Canny sobre níveis de cinza logarítmicos: um degrau conta em porcentagem da sua distância; os dados ausentes são mascarados, assim um buraco não tem borda.</translation></message>
<message><source>The thesis to the letter: 255 / (Smax - Smin), 3x3 Gaussian, 1:3, holes are black.</source><translation>A tese à letra: 255 / (Smax - Smin), gaussiana 3x3, 1:3, os buracos são pretos.</translation></message>
<message><source>As the thesis, but the gray levels run from the nearest to the farthest range.</source><translation>Como a tese, mas os níveis de cinza vão da distância mais próxima à mais distante.</translation></message>
<message><source>As default, for flat and quiet surfaces: low steps are edges far away too.</source><translation>Como default, para superfícies planas e com pouco ruído: os degraus baixos são bordas também ao longe.</translation></message>
<message><source>The default settings of version 4: the noise includes relief, rims end where a surface slants by 70 degrees, and on a scan of rough surfaces folds must exceed their surroundings.</source><translation>Os ajustes padrão da versão 4: o ruído inclui o relevo, as beiras de vazios acabam onde uma superfície se inclina 70 graus, e numa varredura rugosa as dobras têm de exceder o que as rodeia.</translation></message>
<message><source>The default settings of version 3: no rims of open voids, chains of five cells and more, rough scans and turns of the stepper as any other.</source><translation>Os ajustes padrão da versão 3: sem beiras de vazios abertos, cadeias de cinco células ou mais, sem considerar varreduras rugosas nem recuos do motor.</translation></message>
<message><source>Fine to coarse</source><translation>Fino a grosso</translation></message>
<message><source>How easily pieces are joined into one rock. Lower: more and smaller rocks. Higher: fewer and larger rocks.</source><translation>Com que facilidade os pedaços são unidos em uma rocha. Mais baixo: mais rochas, e menores. Mais alto: menos rochas, e maiores.</translation></message>
<message><source>Smallest rock</source><translation>Menor rocha</translation></message>
<message><source>Pieces with fewer measured cells are fines, not rocks.</source><translation>Os pedaços de menos células medidas são finos e não rochas.</translation></message>
<message><source>Farthest rock</source><translation>Rocha mais distante</translation></message>
<message><source>A region farther away is not a rock.</source><translation>O que está mais longe não é uma rocha.</translation></message>
<message><source>Rarely longer than</source><translation>Raramente mais comprido que</translation></message>
<message><source>Longer pieces need better evidence that they are rocks and not walls. The length is about the visible length a.</source><translation>Os pedaços mais longos precisam de melhores sinais de ser uma rocha e não uma parede. O comprimento é aproximadamente o comprimento visível a.</translation></message>
<message><source>Oversize</source><translation>Sobretamanho</translation></message>
<message><source>The share of rocks whose visible width is larger is reported; 0 reports none.</source><translation>É indicada a proporção de rochas cuja largura visível é maior; 0 não indica nenhuma.</translation></message>
<message><source>Easting E [m]</source><translation>Este E [m]</translation></message>
<message><source>Northing N [m]</source><translation>Norte N [m]</translation></message>
<message><source>Datum</source><translation>Datum</translation></message>
<message><source>XYZ and CSV with all columns, and the grid and the record in comment lines: GIS and spreadsheet programs may refuse them</source><translation>XYZ e CSV com todas as colunas, e a grade e o registro em linhas de comentário: os SIG e as planilhas podem recusá-los</translation></message>
<message><source>PCD in mine coordinates with numbers of 8 bytes, which PCL and Open3D do not read; else metres from an origin in a comment</source><translation>PCD em coordenadas da mina com números de 8 bytes, que PCL e Open3D não leem; senão, em metros a partir de uma origem num comentário</translation></message>
<message><source>DXF of release 2000 instead of release 12</source><translation>DXF da versão 2000 em vez da versão 12</translation></message>
<message><source>DXF: also the edge lines of two points only</source><translation>DXF: também as linhas de borda de apenas dois pontos</translation></message>
<message><source>PCD, PLY and CSV: also the cells that were filled and not measured, which the field filled_sd_mm marks</source><translation>PCD, PLY e CSV: também as células preenchidas e não medidas, que o campo filled_sd_mm marca</translation></message>
<message><source>PCD, PLY and CSV: the field confidence, how many percent of nearby settings find the edge too; 0 where there is none</source><translation>PCD, PLY e CSV: o campo confidence, que porcentagem de ajustes próximos também encontra a borda; 0 onde não há</translation></message>
<message><source>PCD, PLY and CSV: the field border, how likely each edge is the border of a rock, in percent; NaN where unknown and where no edge is</source><translation>PCD, PLY e CSV: o campo border, a probabilidade de cada borda ser o contorno de uma rocha, em percentagem; NaN onde é desconhecida e onde não há borda</translation></message>
<message><source>&amp;Edge Cloud…</source><translation>Nuvem de &amp;bordas…</translation></message>
<message><source>Edge points (%1)</source><translation>Pontos de borda (%1)</translation></message>
<message><source>&amp;Full Cloud…</source><translation>Nuvem &amp;completa…</translation></message>
<message><source>All points, with a field for edges (%1)</source><translation>Todos os pontos, com um campo para as bordas (%1)</translation></message>
<message><source>Edge &amp;Image…</source><translation>&amp;Imagem de bordas…</translation></message>
<message><source>Edge map as a picture, %1</source><translation>Mapa de bordas como imagem, %1</translation></message>
<message><source>&amp;Gray Image…</source><translation>Imagem em &amp;tons de cinza…</translation></message>
<message><source>Gray image, %1</source><translation>Imagem em tons de cinza, %1</translation></message>
<message><source>&amp;Range Image…</source><translation>Imagem de &amp;distâncias…</translation></message>
<message><source>Ranges in millimetres as a picture of 16 bits, %1</source><translation>Distâncias em milímetros como imagem de 16 bits, %1</translation></message>
<message><source>&amp;Targets…</source><translation>&amp;Alvos…</translation></message>
<message><source>Targets (%1)</source><translation>Alvos (%1)</translation></message>
<message><source>Report with settings and edits</source><translation>Relatório com ajustes e edições</translation></message>
<message><source>Table, one row per rock</source><translation>Tabela, uma linha por rocha</translation></message>
<message><source>Labels as a 16-bit picture</source><translation>Rótulos como imagem de 16 bits</translation></message>
<message><source>Outlines in space</source><translation>Contornos no espaço</translation></message>
<message><source>Outlines in the mine grid</source><translation>Contornos em coordenadas da mina</translation></message>
<message><source>Convex hulls of the visible points</source><translation>Envoltórias convexas dos pontos visíveis</translation></message>
<message><source>Rock</source><translation>Rocha</translation></message>
<message><source>The number: without edits, 1 is the largest visible area</source><translation>O número: sem edições, 1 é a maior área visível</translation></message>
<message><source>visible length a [m]</source><translation>comprimento visível a [m]</translation></message>
<message><source>Largest visible span across the line of sight; hidden parts are not counted</source><translation>Maior extensão visível transversal à linha de visão; as partes ocultas não contam</translation></message>
<message><source>size: visible width b [m]</source><translation>tamanho: largura visível b [m]</translation></message>
<message><source>Size of the rock: smallest visible span across the line of sight; hidden parts are not counted</source><translation>Tamanho da rocha: menor extensão visível transversal à linha de visão; as partes ocultas não contam</translation></message>
<message><source>± of a and b [m]</source><translation>± de a e b [m]</translation></message>
<message><source>Of a and b: spacing of the points and width of the beam, twice</source><translation>De a e b: espaçamento dos pontos e largura do feixe, duas vezes</translation></message>
<message><source>distance [m]</source><translation>distância [m]</translation></message>
<message><source>From the scanner: median of its ranges</source><translation>A partir do scanner: mediana das suas distâncias</translation></message>
<message><source>area [m²]</source><translation>área [m²]</translation></message>
<message><source>Visible area across the beams</source><translation>Área visível transversal aos feixes</translation></message>
<message><source>in front [%]</source><translation>na frente [%]</translation></message>
<message><source>Share of its outline where it is the nearer side</source><translation>Parte do seu contorno onde ela é o lado mais próximo</translation></message>
<message><source>contacts (≥)</source><translation>contatos (≥)</translation></message>
<message><source>Rocks that it is seen to touch: at least these</source><translation>Rochas que se vê que ela toca: pelo menos estas</translation></message>
<message><source>free below [m]</source><translation>livre abaixo [m]</translation></message>
<message><source>Free height under its lowest visible point: at least this; what sent nothing back is never free; without a pose, up is the scanner's z axis</source><translation>Altura livre sob o seu ponto visível mais baixo: pelo menos esta; o que nada devolveu nunca está livre; sem pose, para cima é o eixo z do scanner</translation></message>
<message><source>arch [°] ± 25</source><translation>arco [°] ± 25</translation></message>
<message><source>Largest angle at it between two rocks that it touches; ↓: it hangs below the line between them; without a pose, up is the scanner's z axis</source><translation>Maior ângulo nela entre duas rochas que ela toca; ↓: pende por baixo da linha que as une; sem pose, para cima é o eixo z do scanner</translation></message>
<message><source>Chance that its outline is right; ▲ and hatched: below 0.85</source><translation>Chance de que o seu contorno esteja correto; ▲ e hachurado: menos de 0.85</translation></message>
<message><source>candidate - geometry only, one viewpoint</source><translation>candidato - apenas geometria, um só ponto de vista</translation></message>
<message><source>Unit</source><translation>Unidade</translation></message>
<message><source>Line angles</source><translation>Ângulos das linhas</translation></message>
<message><source>Order of the lines</source><translation>Ordem das linhas</translation></message>
<message><source>straightened</source><translation>endireitados</translation></message>
<message><source>where their angles say</source><translation>onde dizem os seus ângulos</translation></message>
<message><source>as they were recorded</source><translation>tal como foram gravados</translation></message>
<message><source>straightened by the scan's own surfaces</source><translation>endireitados pelas próprias superfícies da varredura</translation></message>
<message><source>millimetres, so that half of the ranges are below %1 m</source><translation>milímetros, de modo que metade das distâncias é inferior a %1 m</translation></message>
<message><source>millimetres: half of the ranges are below %1 m</source><translation>milímetros: metade das distâncias é inferior a %1 m</translation></message>
<message><source>centimetres, so that half of the ranges are below %1 m</source><translation>centímetros, de modo que metade das distâncias é inferior a %1 m</translation></message>
<message><source>centimetres: half of the ranges are below %1 m</source><translation>centímetros: metade das distâncias é inferior a %1 m</translation></message>
<message><source>metres, so that half of the ranges are below %1 m</source><translation>metros, de modo que metade das distâncias é inferior a %1 m</translation></message>
<message><source>metres: half of the ranges are below %1 m</source><translation>metros: metade das distâncias é inferior a %1 m</translation></message>
<message><source>%2 mm, so that half of the ranges are below %1 m</source><translation>%2 mm, de modo que metade das distâncias é inferior a %1 m</translation></message>
<message><source>In the unit that was taken half of the ranges are below %1 m, which is unusual for a scan of rocks.</source><translation>Na unidade adotada, metade das distâncias é inferior a %1 m, o que não é habitual numa varredura de rochas.</translation></message>
<message><source>spin: the stepper turns about the viewing direction; %1 of %2 flat pieces lie on three planes</source><translation>spin: o motor de passo gira em torno da direção de visada; %1 de %2 pedaços planos estão em três planos</translation></message>
<message><source>spin, about the viewing direction: %1 of %2 flat pieces lie on three planes</source><translation>spin, em torno da direção de visada: %1 de %2 pedaços planos estão em três planos</translation></message>
<message><source>Walls bend with mounting spin: %1 of %2 flat pieces lie on three planes, with sweep %3 do.</source><translation>As paredes curvam-se com a montagem spin: %1 de %2 pedaços planos estão em três planos, com sweep são %3.</translation></message>
<message><source>The ranges do not fit mounting spin: from line to line they stay the same at beams 0 and 180 degrees, as with sweep.</source><translation>As distâncias não combinam com a montagem spin: de linha a linha são iguais nos feixes de 0 e 180 graus, como com sweep.</translation></message>
<message><source>sweep: the stepper turns about the 0/180 degree line; %1 of %2 flat pieces lie on three planes</source><translation>sweep: o motor de passo gira em torno da linha 0/180 graus; %1 de %2 pedaços planos estão em três planos</translation></message>
<message><source>sweep, about the 0/180 degree line: %1 of %2 flat pieces lie on three planes</source><translation>sweep, em torno da linha 0/180 graus: %1 de %2 pedaços planos estão em três planos</translation></message>
<message><source>Walls bend with mounting sweep: %1 of %2 flat pieces lie on three planes, with spin %3 do.</source><translation>As paredes curvam-se com a montagem sweep: %1 de %2 pedaços planos estão em três planos, com spin são %3.</translation></message>
<message><source>The ranges do not fit mounting sweep: from line to line they stay the same at beam 90 degrees, as with spin.</source><translation>As distâncias não combinam com a montagem sweep: de linha a linha são iguais no feixe de 90 graus, como com spin.</translation></message>
<message><source>a step of %3 degrees, %4 in all: %1 of %2 flat pieces lie on three planes</source><translation>um passo de %3 graus, %4 no total: %1 de %2 pedaços planos estão em três planos</translation></message>
<message><source>Walls bend at the line angles that were taken: %1 of %2 flat pieces lie on three planes, other steps give more.</source><translation>As paredes curvam-se com os ângulos de linha adotados: %1 de %2 pedaços planos estão em três planos, outros passos dão mais.</translation></message>
<message><source>a step of %3 degrees, %4 in all; %1 of %2 flat pieces lie on three planes</source><translation>um passo de %3 graus, %4 no total; %1 de %2 pedaços planos estão em três planos</translation></message>
<message><source>a step of %3 degrees, %4 in all; rough rock cannot show it: choose how far the motor turned in all</source><translation>um passo de %3 graus, %4 no total; a rocha rugosa não o pode mostrar: escolha quanto o motor girou no total</translation></message>
<message><source>line angles from %1 to %2 degrees; ranges cannot show whether left and right are exchanged</source><translation>ângulos das linhas de %1 a %2 graus; nenhuma distância diz se esquerda e direita estão trocadas</translation></message>
<message><source>the other way round: left and right exchanged</source><translation>ao contrário: esquerda e direita trocadas</translation></message>
<message><source>%1 lines of %2 beams, found from the directions of the points</source><translation>%1 linhas de %2 feixes, achadas pelas direções dos pontos</translation></message>
<message><source>projected onto cells of %1 degrees; %2 % of the points are behind others of their cell</source><translation>projetado em células de %1 graus; %2 % dos pontos estão atrás de outros da sua célula</translation></message>
<message><source>%1 % of the points are behind others of their cell: the cells are coarse, or the sensor was at another place.</source><translation>%1 % dos pontos estão atrás de outros da sua célula: as células são grossas, ou o sensor estava em outro lugar.</translation></message>
<message><source>cells of %1 degrees</source><translation>células de %1 graus</translation></message>
<message><source>Topic</source><translation>Tópico</translation></message>
<message><source>Sweep</source><translation>Varredura</translation></message>
<message><source>%1: lines of %2 beams; messages: %3, per second: %4</source><translation>%1: linhas de %2 feixes; mensagens: %3, por segundo: %4</translation></message>
<message><source>%1: clouds of %2 points; messages: %3, per second: %4</source><translation>%1: nuvens de %2 pontos; mensagens: %3, por segundo: %4</translation></message>
<message><source>from %1</source><translation>segundo %1</translation></message>
<message><source>sweep %1 of the topic, counted from 0; the topic holds %2</source><translation>varredura %1 do tópico, contada a partir de 0; o tópico contém %2</translation></message>
<message><source>sweep %1, counted from 0</source><translation>varredura %1, contada a partir de 0</translation></message>
<message><source>Beams and lines</source><translation>Feixes e linhas</translation></message>
<message><source>the threshold %1</source><translation>o limiar %1</translation></message>
<message><source>the lower threshold %1</source><translation>o limiar inferior %1</translation></message>
<message><source>the upper threshold %1</source><translation>o limiar superior %1</translation></message>
<message><source>it is an edge, but only %1 % likely the border of a rock, and only those from %2 % on are shown (%3)</source><translation>é uma borda, mas só com %1 % de probabilidade o contorno de uma rocha, e só se mostram os que têm %2 % ou mais (%3)</translation></message>
<message><source>%1 the fold at %2 next to it is stronger (%3 against %4), and an edge is one cell wide</source><translation>%1 a dobra em %2, ao lado, é mais forte (%3 contra %4), e uma borda tem uma célula de largura</translation></message>
<message><source>%1 the fold at %2 next to it is as strong (%3 against %4), and an edge is one cell wide</source><translation>%1 a dobra em %2, ao lado, é igualmente forte (%3 contra %4), e uma borda tem uma célula de largura</translation></message>
<message><source>%1 next to it is stronger (%2), and an edge is one cell wide</source><translation>%1, ao lado, é mais forte (%2), e uma borda tem uma célula de largura</translation></message>
<message><source>%1 next to it is as strong (%2), and an edge is one cell wide</source><translation>%1, ao lado, é tão forte quanto ela (%2), e uma borda tem uma célula de largura</translation></message>
<message><source>the step of %1 m belongs to %2, which is the nearer cell</source><translation>o degrau de %1 m pertence a %2, que é a célula mais próxima</translation></message>
<message><source>%1 is below %2</source><translation>%1 está abaixo de %2</translation></message>
<message><source>%1 does not exceed %2</source><translation>%1 não excede %2</translation></message>
<message><source>%1, and %2 next to it is stronger</source><translation>%1, e %2, ao lado, é mais forte</translation></message>
<message><source>%1 is above %2, but no chain of such cells leads to one above %3</source><translation>%1 está acima de %2, mas nenhuma cadeia de células assim leva a uma acima de %3</translation></message>
<message><source>its chain has 1 cell, fewer than the minimum length %1</source><translation>a sua cadeia tem 1 célula, menos que o comprimento mínimo %1</translation></message>
<message><source>its chain has %1 cells, fewer than the minimum length %2</source><translation>a sua cadeia tem %1 células, menos que o comprimento mínimo %2</translation></message>
<message><source>%1 is enough where it continues its chain</source><translation>%1 basta onde continua a sua cadeia</translation></message>
<message><source>%1 is above %2, and 1 cell on, at %3, its chain reaches %4</source><translation>%1 está acima de %2, e 1 célula adiante, em %3, a sua cadeia alcança %4</translation></message>
<message><source>%1 is above %2, and %3 cells on, at %4, its chain reaches %5</source><translation>%1 está acima de %2, e %3 células adiante, em %4, a sua cadeia alcança %5</translation></message>
<message><source>it is a single cell and takes no part</source><translation>é uma célula isolada e não conta</translation></message>
<message><source>it has no range</source><translation>não tem distância</translation></message>
<message><source>the strength %1 of its %2</source><translation>a força %1 da sua classe “%2”</translation></message>
<message><source>its strength %1</source><translation>a sua força %1</translation></message>
<message><source>%1 is above %2</source><translation>%1 está acima de %2</translation></message>
<message><source>it is next to missing data, and such borders are a class that was chosen</source><translation>está junto a dados em falta, e esses limites são uma classe escolhida</translation></message>
<message><source>the surface ends here before missing data, and what is behind them is farther away</source><translation>a superfície termina aqui diante de dados em falta, e o que está atrás deles está mais longe</translation></message>
<message><source>the surface ends here at an open void, from which nothing came back</source><translation>a superfície termina aqui num vazio aberto, do qual nada voltou</translation></message>
<message><source> (raised: beams are interlaced)</source><translation> (aumentada: os feixes estão entrelaçados)</translation></message>
<message><source>relief %1</source><translation>relevo %1</translation></message>
<message><source>Step in depth: %1 m to %2 (%3; this cell is the nearer one), limit %4: strength %5.</source><translation>Degrau em profundidade: %1 m até %2 (%3; esta célula é a mais próxima), limite %4: força %5.</translation></message>
<message><source>Step in depth: %1 m to %2 (%3; that cell is the nearer one), limit %4: strength %5.</source><translation>Degrau em profundidade: %1 m até %2 (%3; a outra célula é a mais próxima), limite %4: força %5.</translation></message>
<message><source>%1 degrees, which noise alone may look like (%2 %3)</source><translation>%1 graus, o que o ruído por si só pode parecer (%2 %3)</translation></message>
<message><source>%1 degrees = %2</source><translation>%1 graus = %2</translation></message>
<message><source>; %1 % of it counts, for the two sides do not meet at the cell</source><translation>; conta %1 %, pois os dois lados não se encontram na célula</translation></message>
<message><source>Fold: %1 degrees convex, outwards (%2), limit %3: strength %4.</source><translation>Dobra: %1 graus, convexa, para fora (%2), limite %3: força %4.</translation></message>
<message><source>Fold: %1 degrees concave, inwards (%2), limit %3: strength %4.</source><translation>Dobra: %1 graus, côncava, para dentro (%2), limite %3: força %4.</translation></message>
<message><source>Rough scan: %1 % of what is within 15 degrees folds, so a fold must be %2 times as strong here.</source><translation>Varredura rugosa: %1 % do que está a menos de 15 graus dobra, por isso uma dobra tem de ser %2 vezes mais forte aqui.</translation></message>
<message><source>Rough scan: %1 % of what is within 15 degrees folds; a fold counts as elsewhere.</source><translation>Varredura rugosa: %1 % do que está a menos de 15 graus dobra; uma dobra conta como noutros lugares.</translation></message>
<message><source>No range of its own: the gap is filled from both sides, and edges go round it by the cells next to it.</source><translation>Sem distância própria: a falha é preenchida dos dois lados, e as bordas a contornam pelas células vizinhas.</translation></message>
<message><source>No range of its own: the gap was filled on request, and its cells take part like measured ones.</source><translation>Sem distância própria: a falha foi preenchida a pedido, e as suas células contam como as medidas.</translation></message>
<message><source>The edge of a cell without a range next to it goes round by this one.</source><translation>A borda de uma célula vizinha sem distância passa por esta.</translation></message>
<message><source>Nothing is known here: no step and no fold is measured next to missing data.</source><translation>Nada se sabe aqui: junto a dados em falta não se mede degrau nem dobra.</translation></message>
<message><source>Mixed pixel: its range is between two surfaces. For edges it counts as %1 m, the one nearer to its range.</source><translation>Pixel misto: a sua distância está entre duas superfícies. Para as arestas conta como %1 m, a mais próxima da sua distância.</translation></message>
<message><source>Together with the other way %1.</source><translation>Com a outra direção: %1.</translation></message>
<message><source>Range noise used: sigma %1 m here, %2 m at 5 m.</source><translation>Ruído de distância usado: sigma %1 m aqui, %2 m a 5 m.</translation></message>
<message><source>Neighbours err alike, so for folds it counts as %1 m here.</source><translation>Os vizinhos erram juntos, por isso para as dobras conta como %1 m aqui.</translation></message>
<message><source>Noisy ranges are smoothed, so for folds it counts as %1 m here.</source><translation>As distâncias ruidosas são suavizadas, por isso para as dobras conta como %1 m aqui.</translation></message>
<message><source>%1: strength %2 as %3</source><translation>%1: força %2 como %3</translation></message>
<message><source>%1: strength %2</source><translation>%1: força %2</translation></message>
<message><source> (along the line %1, across the lines %2, direction %3 degrees)</source><translation> (ao longo da linha %1, através das linhas %2, direção %3 graus)</translation></message>
<message><source> (direction %1 degrees)</source><translation> (direção %1 graus)</translation></message>
<message><source>; %1 %2, %3 %4 % of it: weak from %5, strong from %6</source><translation>; %1 %2, %3 %4 % dela: fraca desde %5, forte desde %6</translation></message>
<message><source>, threshold %1</source><translation>, limiar %1</translation></message>
<message><source>, thresholds %1 and %2</source><translation>, limiares %1 e %2</translation></message>
<message><source>Chain: 1 cell, strongest at %1 (%2).</source><translation>Cadeia: 1 célula, a mais forte em %1 (%2).</translation></message>
<message><source>Chain: %1 cells, strongest at %2 (%3).</source><translation>Cadeia: %1 células, a mais forte em %2 (%3).</translation></message>
<message><source>It is unknown if it is the border of a rock: the grid ends nearby, ranges are missing, or neighbours err alike.</source><translation>Não se sabe se é o contorno de uma rocha: a grade acaba perto, faltam distâncias, ou os vizinhos erram juntos.</translation></message>
<message><source>It is %1 % likely the border of a rock, and not a fold within one.</source><translation>Com %1 % de probabilidade é o contorno de uma rocha, e não uma dobra dentro de uma.</translation></message>
<message><source>%1 (for it)</source><translation>%1 (a favor)</translation></message>
<message><source>%1 (against it)</source><translation>%1 (contra)</translation></message>
<message><source>What decided that: %1.</source><translation>O que o decide: %1.</translation></message>
<message><source>Left out: %1.</source><translation>De fora: %1.</translation></message>
<message><source>Edge: %1; no value of %2 makes it one.</source><translation>Borda: %1; nenhum valor de “%2” a torna borda.</translation></message>
<message><source>No edge: %1; no value of %2 makes it one.</source><translation>Não é borda: %1; nenhum valor de “%2” a torna borda.</translation></message>
<message><source>Edge: %1; as part of its chain it remains an edge at each %2, up to the largest: %3.</source><translation>Borda: %1; como parte da sua cadeia continua sendo borda com cada %2, até o maior valor: %3.</translation></message>
<message><source>Edge: %1; this remains an edge at each %2, up to the largest: %3.</source><translation>Borda: %1; continua sendo borda com cada %2, até o maior valor: %3.</translation></message>
<message><source>Edge: %1; as part of its chain it disappears only if you set %2 above %3.</source><translation>Borda: %1; como parte da sua cadeia só desaparece se você puser %2 acima de %3.</translation></message>
<message><source>Edge: %1; it disappears if you set %2 above %3, because its chain is then shorter than the minimum length %4.</source><translation>Borda: %1; desaparece se você puser %2 acima de %3, porque a sua cadeia fica então mais curta que o comprimento mínimo %4.</translation></message>
<message><source>Edge: %1; it disappears if you set %2 above %3.</source><translation>Borda: %1; desaparece se você puser %2 acima de %3.</translation></message>
<message><source>No edge: %1; this becomes an edge when %2 is %3 or less.</source><translation>Não é borda: %1; passa a ser uma borda quando %2 é %3 ou menos.</translation></message>
<message><source>%1: range %2 m</source><translation>%1: distância %2 m</translation></message>
<message><source>, gray %1</source><translation>, cinza %1</translation></message>
<message><source>, smoothed %1</source><translation>, suavizado %1</translation></message>
<message><source>, class %1</source><translation>, classe %1</translation></message>
<message><source>steps in depth around it</source><translation>os saltos de profundidade à sua volta</translation></message>
<message><source>its own fold</source><translation>a sua própria dobra</translation></message>
<message><source>the surface across the edge</source><translation>a superfície através da borda</translation></message>
<message><source>the surface along the edge</source><translation>a superfície ao longo da borda</translation></message>
<message><source>its height over the surroundings</source><translation>a sua altura sobre o que a rodeia</translation></message>
<message><source>folds around it</source><translation>as dobras à sua volta</translation></message>
<message><source>distance and noise</source><translation>a distância e o ruído</translation></message>
<message><source>end %1 not on an edge</source><translation>extremo %1 fora de uma borda</translation></message>
<message><source>%1 ends not on an edge</source><translation>%1 extremos fora de uma borda</translation></message>
<message><source>1 end was moved to the near side</source><translation>1 extremidade foi movida para o lado próximo</translation></message>
<message><source>%1 ends were moved to the near side</source><translation>%1 extremidades foram movidas para o lado próximo</translation></message>
<message><source>▲ a nearer surface is within %1 cells of a click</source><translation>▲ há uma superfície mais próxima a menos de %1 células de um clique</translation></message>
<message><source>▲ longer than the %1 m between the clicks: the sides of the throat are up to %2 m from them</source><translation>▲ mais longo que os %1 m entre os cliques: os lados da garganta estão a até %2 m deles</translation></message>
<message><source>▲ its ends are up to %1 m from the clicks: check that it is the opening that was meant</source><translation>▲ suas pontas estão a até %1 m dos cliques: confira se é a abertura desejada</translation></message>
<message><source>its ends are up to %1 m from the clicks</source><translation>suas pontas estão a até %1 m dos cliques</translation></message>
<message><source>▲ a click went through this throat, %1 m behind it: the rim in front was taken</source><translation>▲ um clique passou por esta garganta, %1 m atrás dela: foi tomada a borda da frente</translation></message>
<message><source>▲ no beam came back between its ends: this may be an opening, or dark or wet rock</source><translation>▲ nenhum feixe voltou entre as suas pontas: pode ser uma abertura, ou rocha escura ou molhada</translation></message>
<message><source>▲ one end is %1 m farther away than the other</source><translation>▲ uma extremidade está %1 m mais longe que a outra</translation></message>
<message><source>across the middle of the opening</source><translation>pelo meio da abertura</translation></message>
<message><source>across the opening between the clicks, turned by %1° from their line</source><translation>através da abertura entre os cliques, girado %1° em relação à linha deles</translation></message>
<message><source>between the two sides that were clicked</source><translation>entre os dois lados em que se clicou</translation></message>
<message><source>▲ clicks %1 away find %2 to %3 m: zoom in and click again</source><translation>▲ cliques a %1 encontram de %2 a %3 m: amplie e clique de novo</translation></message>
<message><source>clicks %1 away find %2 to %3 m</source><translation>cliques a %1 dali encontram de %2 a %3 m</translation></message>
<message><source>ranges %1 m</source><translation>distâncias %1 m</translation></message>
<message><source>slope %1° ± %2°, grade %3 %</source><translation>inclinação %1° ± %2°, declive %3 %</translation></message>
<message><source>slope %1° ± %2°</source><translation>inclinação %1° ± %2°</translation></message>
<message><source>a side is below what is resolved there</source><translation>um lado é menor do que o que ali se resolve</translation></message>
<message><source>jumps that are part of it: %1</source><translation>saltos incluídos: %1</translation></message>
<message><source>▲ an end is %1 m behind the surface next to it</source><translation>▲ uma extremidade está %1 m atrás da superfície vizinha</translation></message>
<message><source>between its ends the surface is up to %1 m farther away</source><translation>entre as extremidades a superfície fica até %1 m mais longe</translation></message>
<message><source>between its ends the surface is up to %1 m nearer</source><translation>entre as extremidades a superfície fica até %1 m mais perto</translation></message>
<message><source>no pose: up is the scanner's z</source><translation>sem pose: para cima é o eixo z do scanner</translation></message>
<message><source>Vertical Difference</source><translation>Diferença vertical</translation></message>
<message><source>Angle</source><translation>Ângulo</translation></message>
<message><source>Spans a × b</source><translation>Extensões a × b</translation></message>
<message><source>Along the Surface</source><translation>Ao longo da superfície</translation></message>
<message><source>Throat Width</source><translation>Largura da garganta</translation></message>
<message><source>Length in a Section</source><translation>Comprimento numa secção</translation></message>
</context>
<context>
<name>core</name>
<message><source>the JSON holds too many keys</source><translation>o JSON contém chaves demais</translation></message>
<message><source>the key "%1" appears twice in the same object of the JSON</source><translation>a chave «%1» aparece duas vezes no mesmo objeto do JSON</translation></message>
<message><source>the JSON holds a number that no computer can store</source><translation>o JSON contém um número que nenhum computador pode guardar</translation></message>
<message><source>the JSON is damaged or cut off here</source><translation>o JSON está danificado ou cortado aqui</translation></message>
<message><source>correct the file or choose another</source><translation>corrija o arquivo ou escolha outro</translation></message>
<message><source>%1: byte %2</source><translation>%1: byte %2</translation></message>
<message><source>check line %1, column %2; write 217.4 for 217,4</source><translation>verifique a linha %1, coluna %2; escreva 217.4 em vez de 217,4</translation></message>
<message><source>check line %1, column %2</source><translation>verifique a linha %1, coluna %2</translation></message>
<message><source>this JSON is nested too deep</source><translation>este JSON está aninhado fundo demais</translation></message>
<message><source>this JSON is too large: %1, and %2 are read</source><translation>este JSON é grande demais: %1, e são lidos %2</translation></message>
<message><source>choose another file</source><translation>escolha outro arquivo</translation></message>
<message><source>the file is empty</source><translation>o arquivo está vazio</translation></message>
<message><source>copy it again or choose another</source><translation>copie-o de novo ou escolha outro</translation></message>
<message><source>%n byte behind %1 was not read.</source><translation>%n byte depois de %1 não foi lido.</translation></message>
<message><source>%n bytes behind %1 were not read.</source><translation>%n bytes depois de %1 não foram lidos.</translation></message>
<message><source>this is the address of a file on another computer, %1</source><translation>este é o endereço de um arquivo em outro computador, %1</translation></message>
<message><source>copy the file to this one, or give its path in a folder that is shared</source><translation>copie o arquivo para este, ou dê seu caminho numa pasta compartilhada</translation></message>
<message><source>this is the address of a robot's bridge and not a file</source><translation>este é o endereço da ponte de um robô e não um arquivo</translation></message>
<message><source>use it with record, or in the window with Connect to Scanner</source><translation>use-o com record, ou na janela com Conectar ao scanner</translation></message>
<message><source>this address has a % without the two digits of a byte</source><translation>este endereço tem um % sem os dois algarismos de um byte</translation></message>
<message><source>write % as %25, or give the path</source><translation>escreva % como %25, ou dê o caminho</translation></message>
<message><source>this address names no file</source><translation>este endereço não nomeia arquivo algum</translation></message>
<message><source>give its path</source><translation>dê seu caminho</translation></message>
<message><source>this file was read as an input</source><translation>este arquivo foi lido como entrada</translation></message>
<message><source>this is the file that was read as an input under the name %1</source><translation>este é o arquivo que foi lido como entrada com o nome %1</translation></message>
<message><source>choose another name</source><translation>escolha outro nome</translation></message>
<message><source>nothing (null)</source><translation>nada (null)</translation></message>
<message><source>a list [...]</source><translation>uma lista [...]</translation></message>
<message><source>an object {...}</source><translation>um objeto {...}</translation></message>
<message><source>holds %1 where a number is needed</source><translation>contém %1 onde é necessário um número</translation></message>
<message><source>holds a number out of all reason</source><translation>contém um número fora de toda razão</translation></message>
<message><source>%1 or more</source><translation>%1 ou mais</translation></message>
<message><source>%1 or less</source><translation>%1 ou menos</translation></message>
<message><source>from %1 to %2</source><translation>de %1 a %2</translation></message>
<message><source>is %1 and must be %2</source><translation>é %1 e deve ser %2</translation></message>
<message><source>is missing</source><translation>falta</translation></message>
<message><source>must be a whole number from %1 to %2</source><translation>deve ser um número inteiro de %1 a %2</translation></message>
<message><source>must be true or false</source><translation>deve ser true ou false</translation></message>
<message><source>must be text</source><translation>deve ser texto</translation></message>
<message><source>must be %1</source><translation>deve ser %1</translation></message>
<message><source>must be a list of numbers</source><translation>deve ser uma lista de números</translation></message>
<message><source>must hold %1 numbers</source><translation>deve conter %1 números</translation></message>
<message><source>must hold three numbers</source><translation>deve conter três números</translation></message>
<message><source>must hold three rows of three numbers</source><translation>deve conter três linhas de três números</translation></message>
<message><source>is not a rotation: its rows are not perpendicular and of length 1</source><translation>não é uma rotação: suas linhas não são perpendiculares e de comprimento 1</translation></message>
<message><source>mirrors instead of turning: its determinant is -1</source><translation>espelha em vez de girar: seu determinante é -1</translation></message>
<message><source>must be a time in UTC like "2026-11-20T10:15:30.250Z"</source><translation>deve ser uma hora UTC como "2026-11-20T10:15:30.250Z"</translation></message>
<message><source>must be a list of texts</source><translation>deve ser uma lista de textos</translation></message>
<message><source>must be an object {...}</source><translation>deve ser um objeto {...}</translation></message>
<message><source>must be a list of objects {...}</source><translation>deve ser uma lista de objetos {...}</translation></message>
<message><source>is not a key here, but "%1" is: units belong to the name</source><translation>não é uma chave aqui, mas «%1» é: as unidades fazem parte do nome</translation></message>
<message><source>is not a key here; known are %1</source><translation>não é uma chave aqui; são conhecidas %1</translation></message>
<message><source>"format": "%1"</source><translation>"format": "%1"</translation></message>
<message><source>the JSON holds no object</source><translation>o JSON não contém objeto algum</translation></message>
<message><source>choose a file with %1</source><translation>escolha um arquivo com %1</translation></message>
<message><source>"format" is missing</source><translation>falta "format"</translation></message>
<message><source>"format" is "%1", not "%2"</source><translation>"format" é «%1», não «%2»</translation></message>
<message><source>%n byte</source><translation>%n byte</translation></message>
<message><source>%n bytes</source><translation>%n bytes</translation></message>
<message><source>needs %1 of memory, %2 are free</source><translation>precisa de %1 de memória, há %2 livres</translation></message>
<message><source>close other programs or open a smaller file</source><translation>feche outros programas ou abra um arquivo menor</translation></message>
<message><source>this is not a file of the kind %1, so it was not replaced</source><translation>este não é um arquivo do tipo %1, por isso não foi substituído</translation></message>
<message><source>this is a file of the kind %1, so it was not replaced</source><translation>este é um arquivo do tipo %1, por isso não foi substituído</translation></message>
<message><source>no scanner reaches farther than 1,000 km</source><translation>nenhum scanner alcança mais de 1,000 km</translation></message>
<message><source>unit of counts and numbers</source><translation>unidade das contagens e dos números</translation></message>
<message><source>from a nanometre to a kilometre</source><translation>de um nanômetro a um quilômetro</translation></message>
<message><source>angle of a beam, a heading or a mounting</source><translation>ângulo de um feixe, de um rumo ou de uma montagem</translation></message>
<message><source>degrees</source><translation>graus</translation></message>
<message><source>one turn</source><translation>uma volta</translation></message>
<message><source>angle of a line</source><translation>ângulo de uma linha</translation></message>
<message><source>a stepper that turns on for days</source><translation>um motor de passo que gira durante dias</translation></message>
<message><source>step from beam to beam or line to line</source><translation>passo de feixe a feixe ou de linha a linha</translation></message>
<message><source>not 0: two beams never look the same way</source><translation>não 0: dois feixes nunca olham na mesma direção</translation></message>
<message><source>cell of a projected cloud</source><translation>célula de uma nuvem projetada</translation></message>
<message><source>finer than any scanner, coarser than any use</source><translation>mais fina que a de qualquer scanner, mais grossa que para qualquer uso</translation></message>
<message><source>tilt, pitch</source><translation>inclinação, arfagem</translation></message>
<message><source>beyond it, it is the other way round</source><translation>além disso está ao contrário</translation></message>
<message><source>roll, convergence</source><translation>rolagem, convergência</translation></message>
<message><source>half a turn</source><translation>meia volta</translation></message>
<message><source>easting, northing, place of a sensor</source><translation>este, norte, lugar de um sensor</translation></message>
<message><source>more than the way round the earth</source><translation>mais que a volta à Terra</translation></message>
<message><source>deeper than any mine, higher than any mountain</source><translation>mais fundo que qualquer mina, mais alto que qualquer montanha</translation></message>
<message><source>lever arm on a robot</source><translation>braço de alavanca num robô</translation></message>
<message><source>nothing on a robot is farther away</source><translation>nada num robô está mais longe</translation></message>
<message><source>coordinate, in the file's own unit</source><translation>coordenada, na unidade própria do arquivo</translation></message>
<message><source>the way round the earth in tenths of a millimetre</source><translation>a volta à Terra em décimos de milímetro</translation></message>
<message><source>scale of a mine grid</source><translation>escala de uma grade de mina</translation></message>
<message><source>map projections stay within a hundredth</source><translation>as projeções cartográficas ficam dentro de um centésimo</translation></message>
<message><source>lines, beams</source><translation>linhas, feixes</translation></message>
<message><source>more than a day of scanning</source><translation>mais de um dia de varredura</translation></message>
<message><source>this pipe cannot be read: </source><translation>este pipe não pode ser lido: </translation></message>
<message><source>save what it gives to a file and open that</source><translation>salve o que ele dá num arquivo e abra-o</translation></message>
<message><source>this is a keyboard, not a scan</source><translation>isto é um teclado, não uma varredura</translation></message>
<message><source>give a file, or pipe one in</source><translation>dê um arquivo, ou passe-o por um pipe</translation></message>
<message><source>cancelled</source><translation>cancelado</translation></message>
<message><source>no program writes into this pipe</source><translation>nenhum programa escreve neste pipe</translation></message>
<message><source>start the program that fills it, then open it again</source><translation>inicie o programa que o enche e abra-o de novo</translation></message>
<message><source>this is a device, not a scan</source><translation>isto é um dispositivo, não uma varredura</translation></message>
<message><source>choose a file</source><translation>escolha um arquivo</translation></message>
<message><source>the file cannot be opened: </source><translation>o arquivo não pode ser aberto: </translation></message>
<message><source>check the path</source><translation>verifique o caminho</translation></message>
<message><source>this is not a regular file</source><translation>isto não é um arquivo comum</translation></message>
<message><source>the file cannot be read: </source><translation>o arquivo não pode ser lido: </translation></message>
<message><source>check the disk and the path</source><translation>verifique o disco e o caminho</translation></message>
<message><source>the folder to write into does not exist</source><translation>a pasta de destino não existe</translation></message>
<message><source>make the folder or choose another</source><translation>crie a pasta ou escolha outra</translation></message>
<message><source>the folder to write into is not a folder</source><translation>a pasta de destino não é uma pasta</translation></message>
<message><source>choose another folder</source><translation>escolha outra pasta</translation></message>
<message><source>writing here is not allowed</source><translation>não é permitido escrever aqui</translation></message>
<message><source>choose another folder or ask for the right to write</source><translation>escolha outra pasta ou peça permissão para escrever</translation></message>
<message><source>the disk can only be read</source><translation>o disco é somente leitura</translation></message>
<message><source>the disk is full, so this file was not written</source><translation>o disco está cheio, por isso este arquivo não foi escrito</translation></message>
<message><source>free some space or choose another disk</source><translation>libere espaço ou escolha outro disco</translation></message>
<message><source>the file would be larger than the limit set for it</source><translation>o arquivo seria maior que o limite fixado para ele</translation></message>
<message><source>choose another disk or raise the limit</source><translation>escolha outro disco ou aumente o limite</translation></message>
<message><source>this is a folder, not a file</source><translation>é uma pasta, não um arquivo</translation></message>
<message><source>give a file name</source><translation>indique um nome de arquivo</translation></message>
<message><source>this link leads in a circle</source><translation>este link leva em círculo</translation></message>
<message><source>give the file itself</source><translation>dê o próprio arquivo</translation></message>
<message><source>the file name is too long</source><translation>o nome do arquivo é longo demais</translation></message>
<message><source>choose a shorter name</source><translation>escolha um nome mais curto</translation></message>
<message><source>the file cannot be written: </source><translation>o arquivo não pode ser escrito: </translation></message>
<message><source>choose another folder or disk</source><translation>escolha outra pasta ou outro disco</translation></message>
<message><source>what was read back is not what was written, so this file was not written</source><translation>o que foi relido não é o que foi escrito, então este arquivo não foi escrito</translation></message>
<message><source>check the disk and try again</source><translation>verifique o disco e tente de novo</translation></message>
<message><source>there is no such file; a name with other bytes than UTF-8 does not come through a file dialog</source><translation>não existe tal arquivo; um nome com outros bytes que não UTF-8 não passa por um diálogo de arquivos</translation></message>
<message><source>give the name on the command line, drag the file into the window, or rename it</source><translation>dê o nome na linha de comando, arraste o arquivo para a janela ou renomeie-o</translation></message>
<message><source>there is no such file</source><translation>esse arquivo não existe</translation></message>
<message><source>check the spelling and the folder</source><translation>verifique o nome e a pasta</translation></message>
<message><source>reading this file is not allowed</source><translation>não é permitido ler este arquivo</translation></message>
<message><source>ask its owner for the right to read it</source><translation>peça ao dono permissão para o ler</translation></message>
<message><source>choose a file inside it</source><translation>escolha um arquivo dentro dela</translation></message>
<message><source>the file cannot be read: %1</source><translation>o arquivo não pode ser lido: %1</translation></message>
<message><source>this file is read-only, so it was not replaced</source><translation>este arquivo é somente leitura, por isso não foi substituído</translation></message>
<message><source>allow writing with chmod u+w, or choose another name</source><translation>permita a escrita com chmod u+w ou escolha outro nome</translation></message>
<message><source>this file belongs to another user, who does not allow writing, so it was not replaced</source><translation>este arquivo pertence a outro usuário, que não permite escrever nele; por isso não foi substituído</translation></message>
<message><source>choose another name, or ask its owner</source><translation>escolha outro nome ou pergunte ao seu proprietário</translation></message>
<message><source>; already in place: </source><translation>; já no lugar: </translation></message>
<message><source>no program reads from this pipe</source><translation>nenhum programa lê deste pipe</translation></message>
<message><source>start what reads from it first, or choose a file</source><translation>inicie primeiro o que lê dele, ou escolha um arquivo</translation></message>
<message><source>what reads from this pipe takes nothing</source><translation>o que lê deste pipe não aceita nada</translation></message>
<message><source>start it again, or choose a file</source><translation>inicie-o de novo, ou escolha um arquivo</translation></message>
<message><source>what reads from this pipe has ended</source><translation>o que lê deste pipe terminou</translation></message>
<message><source>there is no file name to write to</source><translation>não há nome de arquivo em que escrever</translation></message>
<message><source>this is a link that belongs to another user</source><translation>este é um link que pertence a outro usuário</translation></message>
<message><source>give the file it leads to, or another name</source><translation>dê o arquivo a que ele leva, ou outro nome</translation></message>
<message><source>two results cannot have one file</source><translation>dois resultados não podem ter um mesmo arquivo</translation></message>
<message><source>give each a name of its own</source><translation>dê a cada um um nome próprio</translation></message>
<message><source>it was cancelled, so nothing was written</source><translation>foi cancelado, por isso nada foi escrito</translation></message>
<message><source>save it again</source><translation>salve outra vez</translation></message>
<message><source>the file cannot be removed (%1)</source><translation>o arquivo não pode ser removido (%1)</translation></message>
<message><source>check the rights of its folder</source><translation>verifique as permissões da sua pasta</translation></message>
<message><source>this is a file and not a folder</source><translation>isto é um arquivo e não uma pasta</translation></message>
<message><source>give the name of a folder</source><translation>indique o nome de uma pasta</translation></message>
<message><source>the folder cannot be made (%1)</source><translation>a pasta não pode ser criada (%1)</translation></message>
<message><source>this is a device or a pipe, not a file</source><translation>isto é um dispositivo ou um pipe, não um arquivo</translation></message>
<message><source>the file is too large for what it should be: %1, and at most %2 are read</source><translation>o arquivo é grande demais para o que deveria ser: %1, e são lidos no máximo %2</translation></message>
<message><source>choose one that can be written to</source><translation>escolha um em que se possa escrever</translation></message>
<message><source>it is compressed with %1 and damaged or cut off</source><translation>está comprimido com %1 e está danificado ou cortado</translation></message>
<message><source>copy the file again</source><translation>copie de novo o arquivo</translation></message>
<message><source>this program was built without %1, which this recording is compressed with</source><translation>este programa foi compilado sem %1, com que esta gravação está comprimida</translation></message>
<message><source>unpack it with "mcap compress --compression none" or "rosbag decompress", or install lib%1 and build again</source><translation>descompacte-o com "mcap compress --compression none" ou "rosbag decompress", ou instale lib%1 e compile de novo</translation></message>
<message><source>it is compressed with "%1", which is not known here</source><translation>está comprimido com «%1», que aqui não é conhecido</translation></message>
<message><source>unpack it with the program that wrote it</source><translation>descompacte-o com o programa que o escreveu</translation></message>
<message><source>other bytes follow the packed data</source><translation>outros bytes seguem os dados comprimidos</translation></message>
<message><source>unpacked this is more than %1, far more than a scan of its size can be</source><translation>descompactado isto é mais de %1, muito mais do que pode ser uma varredura de seu tamanho</translation></message>
<message><source>unpack it by hand and look at it</source><translation>descompacte-o à mão e verifique-o</translation></message>
<message><source>there is not enough memory for this file</source><translation>não há memória suficiente para este arquivo</translation></message>
<message><source>the packed data are damaged%1</source><translation>os dados comprimidos estão danificados%1</translation></message>
<message><source>the packed data end too early</source><translation>os dados comprimidos terminam cedo demais</translation></message>
<message><source>copy the file again, it may be cut off</source><translation>copie de novo o arquivo, pode estar cortado</translation></message>
<message><source>this ZIP archive has no directory at its end</source><translation>este arquivo ZIP não tem diretório no final</translation></message>
<message><source>the directory of this ZIP archive is damaged</source><translation>o diretório deste arquivo ZIP está danificado</translation></message>
<message><source>this ZIP archive does not begin where its directory says: other bytes are before it or in it</source><translation>este arquivo ZIP não começa onde seu diretório indica: há outros bytes antes ou dentro dele</translation></message>
<message><source>this part of the archive is encrypted</source><translation>esta parte do arquivo está criptografada</translation></message>
<message><source>save it without a password</source><translation>salve-o sem senha</translation></message>
<message><source>this part of the archive is packed by method %1</source><translation>esta parte do arquivo está compactada com o método %1</translation></message>
<message><source>pack it with DEFLATE, as usual</source><translation>compacte-o com DEFLATE, como de costume</translation></message>
<message><source>this part of the archive is not where its directory says</source><translation>esta parte do arquivo não está onde seu diretório indica</translation></message>
<message><source>unpacked this is %1, far more than a scan of its size can be</source><translation>descompactado são %1, muito mais do que uma varredura desse tamanho pode ter</translation></message>
<message><source>this part of the archive is damaged: its length or its checksum does not fit</source><translation>esta parte do arquivo está danificada: o comprimento ou a soma de verificação não confere</translation></message>
<message><source>the points are said to begin at byte %1, which is not in the file</source><translation>os pontos começariam no byte %1, que não está no arquivo</translation></message>
<message><source>no list of points begins where the E57 file says</source><translation>nenhuma lista de pontos começa onde o arquivo E57 indica</translation></message>
<message><source>export the file again</source><translation>exporte de novo o arquivo</translation></message>
<message><source>the header of the points does not fit the file</source><translation>o cabeçalho dos pontos não corresponde ao arquivo</translation></message>
<message><source>a packet of points %1</source><translation>um pacote de pontos %1</translation></message>
<message><source>is too short</source><translation>é curto demais</translation></message>
<message><source>holds %1 and the file describes %2</source><translation>contém %1 e o arquivo descreve %2</translation></message>
<message><source>%n column</source><translation>%n coluna</translation></message>
<message><source>%n columns</source><translation>%n colunas</translation></message>
<message><source>ends within its header</source><translation>termina dentro de seu cabeçalho</translation></message>
<message><source>promises more bytes than it has</source><translation>anuncia mais bytes do que tem</translation></message>
<message><source>a packet of points is of kind %1, which E57 does not have</source><translation>um pacote de pontos é do tipo %1, que o E57 não tem</translation></message>
<message><source>a packet of points says that it has %1 bytes, which are not there</source><translation>um pacote de pontos diz que tem %1 bytes, que não estão ali</translation></message>
<message><source>the file promises %1 and has %2 bytes for them</source><translation>o arquivo anuncia %1 e tem %2 bytes para eles</translation></message>
<message><source>%n point</source><translation>%n ponto</translation></message>
<message><source>%n points</source><translation>%n pontos</translation></message>
<message><source>the file promises %1 and the column %2 ends after %3</source><translation>o arquivo anuncia %1 e a coluna %2 termina depois de %3</translation></message>
<message><source>the file ends within its E57 header</source><translation>o arquivo termina dentro do cabeçalho E57</translation></message>
<message><source>this is E57 version %1.%2, and version 1 is known</source><translation>isto é E57 versão %1.%2, e é conhecida a versão 1</translation></message>
<message><source>export it as E57 version 1.0</source><translation>exporte-o como E57 versão 1.0</translation></message>
<message><source>the E57 header says that pages have %1 bytes</source><translation>o cabeçalho E57 indica páginas de %1 bytes</translation></message>
<message><source>%1: byte 40</source><translation>%1: byte 40</translation></message>
<message><source>the E57 header promises %1 bytes and the file holds %2</source><translation>o cabeçalho E57 anuncia %1 bytes e o arquivo contém %2</translation></message>
<message><source>the columns of points in this E57 file are nested too deep</source><translation>as colunas de pontos deste arquivo E57 estão aninhadas demais</translation></message>
<message><source>the limits of the column %1 in this E57 file are not possible</source><translation>os limites da coluna %1 deste arquivo E57 não são possíveis</translation></message>
<message><source>scan %1 of this E57 file does not say where its points are and how many</source><translation>a varredura %1 deste arquivo E57 não indica onde estão seus pontos nem quantos são</translation></message>
<message><source>the E57 header says that the XML part is at byte %1 and has %2 bytes, which are not in the file</source><translation>o cabeçalho E57 diz que a parte XML está no byte %1 e tem %2 bytes, que não estão no arquivo</translation></message>
<message><source>%1: byte 24</source><translation>%1: byte 24</translation></message>
<message><source>the XML part of this E57 file cannot be read: </source><translation>não é possível ler a parte XML deste arquivo E57: </translation></message>
<message><source>the XML part of this E57 file has no e57Root</source><translation>a parte XML deste arquivo E57 não tem e57Root</translation></message>
<message><source>page %1 of %2 of this E57 file is damaged: its checksum does not fit</source><translation>a página %1 de %2 deste arquivo E57 está danificada: a soma de verificação não confere</translation></message>
<message><source>this E57 file ends before something that it names</source><translation>este arquivo E57 termina antes de algo que nomeia</translation></message>
<message><source>a file of this name exists already and a recording overwrites nothing</source><translation>já existe um arquivo com este nome e uma gravação não sobrescreve nada</translation></message>
<message><source>the folder to record into does not exist</source><translation>a pasta em que gravar não existe</translation></message>
<message><source>recording here is not allowed</source><translation>não é permitido gravar aqui</translation></message>
<message><source>the disk is full, nothing is recorded</source><translation>o disco está cheio, nada é gravado</translation></message>
<message><source>the recording cannot be started: </source><translation>a gravação não pode começar: </translation></message>
<message><source>the disk is full, the recording ends here</source><translation>o disco está cheio, a gravação termina aqui</translation></message>
<message><source>free some space and start a new recording</source><translation>libere espaço e comece uma nova gravação</translation></message>
<message><source>the file has reached the limit set for its size, the recording ends here</source><translation>o arquivo atingiu o limite fixado para seu tamanho, a gravação termina aqui</translation></message>
<message><source>start a new recording</source><translation>comece uma nova gravação</translation></message>
<message><source>the recording ends here: </source><translation>a gravação termina aqui: </translation></message>
<message><source>check the disk and start a new recording</source><translation>verifique o disco e comece uma nova gravação</translation></message>
<message><source>the disk reports that it lost some of what was recorded: </source><translation>o disco informa que perdeu parte do que foi gravado: </translation></message>
<message><source>check the disk, and start a new recording on another one</source><translation>verifique o disco, e comece uma nova gravação em outro</translation></message>
<message><source>bytes %1 to %2 are damaged and were left out</source><translation>os bytes %1 a %2 estão danificados e foram deixados de fora</translation></message>
<message><source>%1 more places are damaged or were left out</source><translation>%1 outros lugares estão danificados ou foram deixados de fora</translation></message>
<message><source>it is not a whole chunk</source><translation>não é um bloco completo</translation></message>
<message><source>its checksum does not fit</source><translation>sua soma de verificação não confere</translation></message>
<message><source>it promises to unpack to %1, more than a file of this size holds</source><translation>anuncia que se descompacta em %1, mais do que um arquivo deste tamanho contém</translation></message>
<message><source>the chunk at byte %1 was left out: %2</source><translation>o bloco no byte %1 foi deixado de fora: %2</translation></message>
<message><source>the end of the recording</source><translation>o fim da gravação</translation></message>
<message><source>the file says that it holds %1 and %2 could be read</source><translation>o arquivo diz que contém %1 e puderam ser lidas %2</translation></message>
<message><source>%n message</source><translation>%n mensagem</translation></message>
<message><source>%n messages</source><translation>%n mensagens</translation></message>
<message><source>this is not an MCAP recording of a known version</source><translation>não é uma gravação MCAP de versão conhecida</translation></message>
<message><source>choose a recording</source><translation>escolha uma gravação</translation></message>
<message><source>unknown reason</source><translation>motivo desconhecido</translation></message>
<message><source>out of memory</source><translation>memória insuficiente</translation></message>
<message><source>the file ends too early</source><translation>o arquivo termina cedo demais</translation></message>
<message><source>there are no cells to make a picture of</source><translation>não há células de que fazer uma imagem</translation></message>
<message><source>open a scan first</source><translation>primeiro abra uma varredura</translation></message>
<message><source>the picture cannot be made: </source><translation>a imagem não pode ser feita: </translation></message>
<message><source>free some memory</source><translation>libere memória</translation></message>
<message><source>the picture cannot be read: </source><translation>a imagem não pode ser lida: </translation></message>
<message><source>save it again as PNG</source><translation>salve-a de novo como PNG</translation></message>
<message><source>the picture has %1 x %2 pixels; at most %3 are taken</source><translation>a imagem tem %1 x %2 pixels; são aceitos no máximo %3</translation></message>
<message><source>make the picture smaller</source><translation>faça a imagem menor</translation></message>
<message><source>this is not a readable PNG picture: </source><translation>isto não é uma imagem PNG legível: </translation></message>
<message><source>save the mask again as PNG</source><translation>salve de novo a máscara como PNG</translation></message>
<message><source>this picture has 16 bits per pixel where 8 are needed</source><translation>esta imagem tem 16 bits por pixel onde são necessários 8</translation></message>
<message><source>save the mask as 8-bit gray</source><translation>salve a máscara em cinza de 8 bits</translation></message>
<message><source>the picture promises more pixels than the file can hold</source><translation>a imagem anuncia mais pixels do que o arquivo pode conter</translation></message>
<message><source>export it again</source><translation>exporte-o de novo</translation></message>
<message><source>this build has no robots: it reads no ROS bags, no VLP-16, no Ouster and no Foxglove bridge</source><translation>esta versão não tem robôs: não lê bags do ROS, nem VLP-16, nem Ouster, nem ponte Foxglove</translation></message>
<message><source>use a build with robots (EDGESCAN_ROBOTS)</source><translation>use uma versão com robôs (EDGESCAN_ROBOTS)</translation></message>
<message><source>this is not a whole DXF group</source><translation>isto não é um grupo DXF completo</translation></message>
<message><source>this coordinate is not a number</source><translation>esta coordenada não é um número</translation></message>
<message><source>reading points</source><translation>leitura dos pontos</translation></message>
<message><source>%n point shares its row and column with a nearer one, which was taken (several returns of one beam).</source><translation>%n ponto partilha a sua fileira e coluna com um mais próximo, que foi tomado (vários retornos de um feixe).</translation></message>
<message><source>%n points share their row and column with a nearer one, which was taken (several returns of one beam).</source><translation>%n pontos partilham a sua fileira e coluna com um mais próximo, que foi tomado (vários retornos de um feixe).</translation></message>
<message><source>this E57 file holds no scan, only %1</source><translation>este arquivo E57 não contém varredura alguma, só %1</translation></message>
<message><source>%n picture</source><translation>%n imagem</translation></message>
<message><source>%n pictures</source><translation>%n imagens</translation></message>
<message><source>this E57 file holds no scan</source><translation>este arquivo E57 não contém nenhuma varredura</translation></message>
<message><source>The file holds %1 scans; this is number %2, --scan chooses another.</source><translation>O arquivo contém %1 varreduras; esta é a número %2, --scan escolhe outra.</translation></message>
<message><source>The first %1 of these scans hold no point with a return.</source><translation>As primeiras %1 destas varreduras não têm nenhum ponto com retorno.</translation></message>
<message><source>The rows and columns that the file gives its points make no grid and were not used.</source><translation>As fileiras e colunas que o arquivo dá aos seus pontos não formam uma grade e não foram usadas.</translation></message>
<message><source>The file does not say which way the scan lines run: its columns were taken as lines, its rows as beams.</source><translation>O arquivo não diz em que sentido vão as linhas: as suas colunas foram tomadas como linhas, as suas fileiras como feixes.</translation></message>
<message><source>scan %1 of this E57 file</source><translation>a varredura %1 deste arquivo E57</translation></message>
<message><source>%1 holds no points</source><translation>%1 não contém pontos</translation></message>
<message><source>choose another scan or file</source><translation>escolha outra varredura ou arquivo</translation></message>
<message><source>%1 has neither cartesian nor spherical coordinates, only %2</source><translation>%1 não tem coordenadas cartesianas nem esféricas, só %2</translation></message>
<message><source>export it with coordinates</source><translation>exporte-o com coordenadas</translation></message>
<message><source>The angles of the points were taken as degrees, because no elevation in radians is so large.</source><translation>Os ângulos dos pontos foram tomados como graus, porque nenhuma elevação em radianos é tão grande.</translation></message>
<message><source>%n point has a range below 0 and counts as no return.</source><translation>%n ponto tem uma distância menor que 0 e conta como sem retorno.</translation></message>
<message><source>%n points have a range below 0 and count as no return.</source><translation>%n pontos têm uma distância menor que 0 e contam como sem retorno.</translation></message>
<message><source>%n point is marked as invalid in the file and counts as no return.</source><translation>%n ponto está marcado como inválido no arquivo e conta como sem retorno.</translation></message>
<message><source>%n points are marked as invalid in the file and count as no return.</source><translation>%n pontos estão marcados como inválidos no arquivo e contam como sem retorno.</translation></message>
<message><source>What else a point of this file has is not read: %1.</source><translation>O mais que um ponto deste arquivo tem não é lido: %1.</translation></message>
<message><source>The pictures of this file (%1) are not read.</source><translation>As imagens deste arquivo (%1) não são lidas.</translation></message>
<message><source>the end that the header gives</source><translation>o fim que o cabeçalho dá</translation></message>
<message><source>The pose in the file is not a rotation and shift, so the scan stays in the scanner's frame.</source><translation>A pose do arquivo não é uma rotação e translação, portanto a varredura fica no referencial do scanner.</translation></message>
<message><source>choose a scan file</source><translation>escolha um arquivo de varredura</translation></message>
<message><source>it may be what a site sent instead of the file: download the file again, or choose a scan file</source><translation>talvez um site a tenha enviado no lugar do arquivo: baixe de novo o arquivo ou escolha um arquivo de varredura</translation></message>
<message><source>unpack it and open the scan in it</source><translation>descompacte-o e abra a varredura que contém</translation></message>
<message><source>save its points as PLY in MeshLab</source><translation>salve os seus pontos como PLY no MeshLab</translation></message>
<message><source>choose the scan that it was made from</source><translation>escolha a varredura da qual foi feito</translation></message>
<message><source>save the ranges as .npy or .csv</source><translation>salve as distâncias como .npy ou .csv</translation></message>
<message><source>this is a JPEG picture, not a scan</source><translation>é uma imagem JPEG, não uma varredura</translation></message>
<message><source>this is a GIF picture, not a scan</source><translation>isto é uma imagem GIF, não uma varredura</translation></message>
<message><source>this is a picture, sound or film (RIFF), not a scan</source><translation>isto é uma imagem, um som ou um filme (RIFF), não uma varredura</translation></message>
<message><source>this is a picture or film, not a scan</source><translation>é uma imagem ou um filme, não uma varredura</translation></message>
<message><source>this is a Photoshop picture, not a scan</source><translation>isto é uma imagem do Photoshop, não uma varredura</translation></message>
<message><source>this is a program, not a scan</source><translation>é um programa, não uma varredura</translation></message>
<message><source>this is a PDF document, not a scan</source><translation>é um documento PDF, não uma varredura</translation></message>
<message><source>this is a ZIP archive, not a scan</source><translation>é um arquivo compactado ZIP, não uma varredura</translation></message>
<message><source>this is a gzip archive in another one, not a scan</source><translation>isto é um arquivo gzip dentro de outro, não uma varredura</translation></message>
<message><source>this is an xz archive, not a scan</source><translation>isto é um arquivo xz, não uma varredura</translation></message>
<message><source>unpack it (xz -d) and open the scan in it</source><translation>descompacte-o (xz -d) e abra a varredura que ele contém</translation></message>
<message><source>this is a bzip2 archive, not a scan</source><translation>isto é um arquivo bzip2, não uma varredura</translation></message>
<message><source>unpack it (bzip2 -d) and open the scan in it</source><translation>descompacte-o (bzip2 -d) e abra a varredura que ele contém</translation></message>
<message><source>this is a zstd archive, not a scan</source><translation>isto é um arquivo zstd, não uma varredura</translation></message>
<message><source>unpack it (zstd -d) and open the scan in it</source><translation>descompacte-o (zstd -d) e abra a varredura que ele contém</translation></message>
<message><source>this is a 7-Zip archive, not a scan</source><translation>isto é um arquivo 7-Zip, não uma varredura</translation></message>
<message><source>this is a RAR archive, not a scan</source><translation>isto é um arquivo RAR, não uma varredura</translation></message>
<message><source>this is an HDF5 file, which is not read</source><translation>isto é um arquivo HDF5, que não é lido</translation></message>
<message><source>this is a MATLAB file, which is not read</source><translation>isto é um arquivo do MATLAB, que não é lido</translation></message>
<message><source>save the ranges with writematrix(ranges, 'scan.csv')</source><translation>salve as distâncias com writematrix(ranges, 'scan.csv')</translation></message>
<message><source>this is an old Office document, not a scan</source><translation>isto é um documento antigo do Office, não uma varredura</translation></message>
<message><source>save the table as .csv</source><translation>salve a tabela como .csv</translation></message>
<message><source>this is a Parquet table, which is not read</source><translation>isto é um arquivo Parquet, que não é lido</translation></message>
<message><source>this is an Arrow table, which is not read</source><translation>isto é um arquivo Arrow, que não é lido</translation></message>
<message><source>this is a glTF model, which is not read</source><translation>isto é um modelo glTF, que não é lido</translation></message>
<message><source>save it as PLY in Blender or MeshLab</source><translation>salve-o como PLY no Blender ou MeshLab</translation></message>
<message><source>this is a STEP model, not a scan</source><translation>isto é um modelo STEP, não uma varredura</translation></message>
<message><source>this is an FBX model, which is not read</source><translation>isto é um modelo FBX, que não é lido</translation></message>
<message><source>save it as PLY in Blender</source><translation>salve-o como PLY no Blender</translation></message>
<message><source>this is a web page (HTML), not a scan</source><translation>é uma página web (HTML), não uma varredura</translation></message>
<message><source>this is an SVG picture, not a scan</source><translation>isto é uma imagem SVG, não uma varredura</translation></message>
<message><source>this is an XML document, not a scan</source><translation>isto é um documento XML, não uma varredura</translation></message>
<message><source>this is a text document (RTF), not a scan</source><translation>isto é um documento de texto (RTF), não uma varredura</translation></message>
<message><source>this is a PostScript document, not a scan</source><translation>isto é um documento PostScript, não uma varredura</translation></message>
<message><source>this is a file of VTK, which is not read</source><translation>isto é um arquivo do VTK, que não é lido</translation></message>
<message><source>save its points as PLY, or as CSV from ParaView's table</source><translation>salve os seus pontos como PLY, ou como CSV da tabela do ParaView</translation></message>
<message><source>this is an OFF mesh, which is not read</source><translation>isto é um modelo OFF, que não é lido</translation></message>
<message><source>this is a VRML scene, which is not read</source><translation>isto é uma cena VRML, que não é lida</translation></message>
<message><source>this is a table of rocks, not a scan</source><translation>isto é uma tabela de rochas, não uma varredura</translation></message>
<message><source>this is a raster of heights (Esri ASCII grid), not a scan</source><translation>isto é um raster de alturas (grade ASCII da Esri), não uma varredura</translation></message>
<message><source>this is a raster of heights (Surfer grid), not a scan</source><translation>isto é um raster de alturas (grade do Surfer), não uma varredura</translation></message>
<message><source>export it as E57 with FARO SCENE</source><translation>exporte-o como E57 com o FARO SCENE</translation></message>
<message><source>export it as E57 or LAS with RiSCAN PRO, or with RIEGL's rdbconvert</source><translation>exporte-o como E57 ou LAS com RiSCAN PRO, ou com rdbconvert da RIEGL</translation></message>
<message><source>export it as E57 with Z+F LaserControl</source><translation>exporte-o como E57 com o Z+F LaserControl</translation></message>
<message><source>export it as E57 or PTX with Leica Cyclone</source><translation>exporte-o como E57 ou PTX com o Leica Cyclone</translation></message>
<message><source>export it as E57 with Autodesk ReCap</source><translation>exporte-o como E57 com o Autodesk ReCap</translation></message>
<message><source>this is a FARO scan (FLS), which is not read</source><translation>isto é um arquivo FARO (FLS), que não é lido</translation></message>
<message><source>this is a FARO workspace, which is not read</source><translation>isto é um espaço de trabalho FARO, que não é lido</translation></message>
<message><source>this is a FARO project, which is not read</source><translation>isto é um projeto FARO, que não é lido</translation></message>
<message><source>this is a RIEGL stream (RXP), which is not read</source><translation>isto é um fluxo RIEGL (RXP), que não é lido</translation></message>
<message><source>this is a RIEGL database, which is not read</source><translation>isto é uma base de dados RIEGL, que não é lida</translation></message>
<message><source>this is a RIEGL database (RDBX), which is not read</source><translation>isto é uma base de dados RIEGL (RDBX), que não é lida</translation></message>
<message><source>this is a RIEGL scan (3DD), which is not read</source><translation>isto é um arquivo RIEGL (3DD), que não é lido</translation></message>
<message><source>this is a Z+F scan (ZFS), which is not read</source><translation>isto é um arquivo Z+F (ZFS), que não é lido</translation></message>
<message><source>this is a Z+F project (ZFPRJ), which is not read</source><translation>isto é um projeto Z+F (ZFPRJ), que não é lido</translation></message>
<message><source>this is a Z+F scan (ZFC), which is not read</source><translation>isto é um arquivo Z+F (ZFC), que não é lido</translation></message>
<message><source>this is a Leica LGS project, which is not read</source><translation>isto é um projeto Leica LGS, que não é lido</translation></message>
<message><source>this is a Leica LGSx project, which is not read</source><translation>isto é um projeto Leica LGSx, que não é lido</translation></message>
<message><source>this is a Leica Cyclone database, which is not read</source><translation>isto é uma base de dados Leica Cyclone, que não é lida</translation></message>
<message><source>this is an Autodesk ReCap project, which is not read</source><translation>isto é um projeto Autodesk ReCap, que não é lido</translation></message>
<message><source>this is an Autodesk ReCap scan, which is not read</source><translation>isto é um arquivo Autodesk ReCap, que não é lido</translation></message>
<message><source>this is a Trimble scan (TZF), which is not read</source><translation>isto é um arquivo Trimble (TZF), que não é lido</translation></message>
<message><source>export it as E57 with Trimble RealWorks</source><translation>exporte-o como E57 com o Trimble RealWorks</translation></message>
<message><source>this is a Topcon scan (CL3), which is not read</source><translation>isto é um arquivo Topcon (CL3), que não é lido</translation></message>
<message><source>export it as E57 or PTX with Topcon's program</source><translation>exporte-o como E57 ou PTX com o programa da Topcon</translation></message>
<message><source>this is a Topcon scan (CLR), which is not read</source><translation>isto é um arquivo Topcon (CLR), que não é lido</translation></message>
<message><source>this is a Pointools cloud (POD), which is not read</source><translation>isto é um arquivo Pointools (POD), que não é lido</translation></message>
<message><source>export it as LAS with Bentley's program</source><translation>exporte-o como LAS com o programa da Bentley</translation></message>
<message><source>this is a Python pickle, which only Python can open</source><translation>isto é um pickle do Python, que só o Python pode abrir</translation></message>
<message><source>this is a ROS bag that does not begin like one</source><translation>isto é um bag do ROS que não começa como tal</translation></message>
<message><source>copy it again</source><translation>copie-a novamente</translation></message>
<message><source>this is a ROS 2 bag that does not begin like one</source><translation>isto é um bag do ROS 2 que não começa como tal</translation></message>
<message><source>this is a binary file without a telegram of a SICK scanner in it</source><translation>isto é um arquivo binário sem telegrama de um scanner SICK</translation></message>
<message><source>save points as PCD or PLY; a capture of telegrams holds the bytes as they came from the scanner</source><translation>salve os pontos como PCD ou PLY; uma captura de telegramas contém os bytes tal como vieram do scanner</translation></message>
<message><source>this is a BMP picture, not a scan</source><translation>isto é uma imagem BMP, não uma varredura</translation></message>
<message><source>this is a drawing (DXF), which is not read</source><translation>isto é um desenho (DXF), que não é lido</translation></message>
<message><source>choose the scan, or save the points of the drawing as CSV, LAS or PLY</source><translation>escolha a varredura, ou salve os pontos do desenho como CSV, LAS ou PLY</translation></message>
<message><source>this is an Excel workbook, not a table of text</source><translation>isto é uma pasta do Excel, não uma tabela de texto</translation></message>
<message><source>save the sheet as .csv</source><translation>salve a planilha como .csv</translation></message>
<message><source>this is an OpenDocument spreadsheet, not a table of text</source><translation>isto é uma planilha OpenDocument, não uma tabela de texto</translation></message>
<message><source>this is a numpy archive, which is not read</source><translation>isto é uma coleção numpy, que não é lida</translation></message>
<message><source>save the array of ranges or points as .npy</source><translation>salve a matriz de distâncias ou pontos como .npy</translation></message>
<message><source>this is a ROS bag, and %1</source><translation>isto é um bag de ROS, e %1</translation></message>
<message><source>Network capture</source><translation>Captura de rede</translation></message>
<message><source>The picture asks to be turned or mirrored when it is shown (orientation %1): its rows were taken as scan lines as they are stored.</source><translation>A imagem pede para ser girada ou espelhada ao ser mostrada (orientação %1): as suas fileiras foram tomadas como linhas tal como estão gravadas.</translation></message>
<message><source>the picture promises more pixels than a file of %1 holds of a scan</source><translation>a imagem anuncia mais pixels do que um arquivo de %1 contém de uma varredura</translation></message>
<message><source>a pixel</source><translation>um pixel</translation></message>
<message><source>%n pixel holds no range (negative, not a number, or too far) and was taken as no return.</source><translation>%n pixel não contém distância (negativo, não numérico ou longe demais) e foi tomado como sem retorno.</translation></message>
<message><source>%n pixels hold no range (negative, not a number, or too far) and were taken as no return.</source><translation>%n pixels não contêm distância (negativos, não numéricos ou longe demais) e foram tomados como sem retorno.</translation></message>
<message><source>Unit taken as millimetres, as range pictures have it.</source><translation>Unidade tomada como milímetros, como nas imagens de distâncias.</translation></message>
<message><source>this TIFF picture has %1 of %2 bits, and ranges need one of 16 bits or of 4-byte floats</source><translation>esta imagem TIFF tem %1 de %2 bits, e as distâncias precisam de um de 16 bits ou de números de 4 bytes</translation></message>
<message><source>%n channel</source><translation>%n canal</translation></message>
<message><source>%n channels</source><translation>%n canais</translation></message>
<message><source>choose a scan, or a range picture of 16 bits per pixel</source><translation>escolha uma varredura, ou uma imagem de distâncias de 16 bits por pixel</translation></message>
<message><source>this TIFF picture is stored in tiles</source><translation>esta imagem TIFF está salva em blocos</translation></message>
<message><source>save it in strips</source><translation>salve-a em faixas</translation></message>
<message><source>the picture has no pixels</source><translation>a imagem não tem pixels</translation></message>
<message><source>the TIFF picture is damaged or of a kind that cannot be read</source><translation>a imagem TIFF está danificada ou é de um tipo que não pode ser lido</translation></message>
<message><source>reading the picture</source><translation>leitura da imagem</translation></message>
<message><source>The file holds %1 (pages); the first was read.</source><translation>O arquivo contém %1 (páginas); foi lida a primeira.</translation></message>
<message><source>the picture</source><translation>a imagem</translation></message>
<message><source>this is a TIFF picture, and this build of the program cannot read TIFF</source><translation>isto é uma imagem TIFF, e esta versão do programa não pode ler TIFF</translation></message>
<message><source>save the ranges as PNG of 16 bits</source><translation>salve as distâncias como PNG de 16 bits</translation></message>
<message><source>this is a PNG picture of %1 bit gray, and ranges need 16 bit gray</source><translation>isto é uma imagem PNG de %1 bits em cinza, e as distâncias precisam de 16 bits em cinza</translation></message>
<message><source>this is a PNG picture of %1 bit colour, and ranges need 16 bit gray</source><translation>isto é uma imagem PNG de %1 bits em cores, e as distâncias precisam de 16 bits em cinza</translation></message>
<message><source>The picture is animated; the first frame was read.</source><translation>A imagem é animada; foi lido o primeiro quadro.</translation></message>
<message><source>The picture does not end with IEND: the file was cut off behind its pixels.</source><translation>A imagem não termina com IEND: o arquivo foi cortado depois dos seus pixels.</translation></message>
<message><source>this is a PNG picture that cannot be read: </source><translation>isto é uma imagem PNG que não pode ser lida: </translation></message>
<message><source>close other programs</source><translation>feche outros programas</translation></message>
<message><source>the file ends within its LAS header</source><translation>o arquivo termina dentro do seu cabeçalho LAS</translation></message>
<message><source>this is LAS version %1.%2, and versions up to 1.4 are known</source><translation>isto é LAS versão %1.%2, e são conhecidas as versões até 1.4</translation></message>
<message><source>save it as LAS 1.2 or 1.4</source><translation>salve-o como LAS 1.2 ou 1.4</translation></message>
<message><source>the LAS header says it is %1 bytes long</source><translation>o cabeçalho LAS diz que tem %1 bytes</translation></message>
<message><source>the scale or offset in the LAS header is not a number that coordinates can have</source><translation>a escala ou o deslocamento do cabeçalho LAS não é um número que coordenadas possam ter</translation></message>
<message><source>points of format %1 with %2 bytes are none that LAS knows</source><translation>o LAS não conhece pontos do formato %1 com %2 bytes</translation></message>
<message><source>the file holds no points</source><translation>o arquivo não contém pontos</translation></message>
<message><source>the points begin at byte %1, which is not in the file</source><translation>os pontos começam no byte %1, que não está no arquivo</translation></message>
<message><source>the header promises %1 of %2 bytes and the file holds %3 bytes of them</source><translation>o cabeçalho anuncia %1 de %2 bytes e o arquivo contém %3 bytes deles</translation></message>
<message><source>The end of the file is damaged or missing: %1 of %2 records behind the points cannot be read. A grid, cell states or a place in the mine that they held are lost; copy the file again.</source><translation>O fim do arquivo está danificado ou falta: %1 de %2 registros depois dos pontos não podem ser lidos. Uma grade, estados de células ou um lugar na mina que continham estão perdidos; copie de novo o arquivo.</translation></message>
<message><source>the %1 that the header promises</source><translation>os %1 que o cabeçalho anuncia</translation></message>
<message><source>the last record</source><translation>o último registro</translation></message>
<message><source>The waveforms of this file were not read.</source><translation>As formas de onda deste arquivo não foram lidas.</translation></message>
<message><source>describes a scan of %1 valid cells and holds %2</source><translation>descreve uma varredura de %1 células válidas e contém %2</translation></message>
<message><source>save the scan again</source><translation>salve de novo a varredura</translation></message>
<message><source>x and y of this file are degrees of longitude and latitude, as its coordinate system says, and points need metres</source><translation>x e y deste arquivo são graus de longitude e latitude, segundo o seu sistema de coordenadas, e os pontos precisam de metros</translation></message>
<message><source>export it in a projected coordinate system such as UTM</source><translation>exporte-o num sistema de coordenadas projetado como UTM</translation></message>
<message><source>The coordinate system of the file is %1, without its unit: metres were taken. --unit says another one.</source><translation>O sistema de coordenadas do arquivo é %1, sem a sua unidade: foram tomados metros. --unit indica outra.</translation></message>
<message><source>The coordinate system of the file gives lengths in %1 of %2 mm: they were converted.</source><translation>O sistema de coordenadas do arquivo dá os comprimentos em %1 de %2 mm: foram convertidos.</translation></message>
<message><source>Heights of the file have another unit than x and y, %1 mm: they were converted.</source><translation>As alturas do arquivo têm outra unidade que x e y, %1 mm: foram convertidas.</translation></message>
<message><source>%n point is marked as withheld in the file and counts as no return.</source><translation>%n ponto está marcado como excluído no arquivo e conta como sem retorno.</translation></message>
<message><source>%n points are marked as withheld in the file and count as no return.</source><translation>%n pontos estão marcados como excluídos no arquivo e contam como sem retorno.</translation></message>
<message><source>there are no points to save</source><translation>não há pontos para salvar</translation></message>
<message><source>choose other cells or settings</source><translation>escolha outras células ou outros ajustes</translation></message>
<message><source>LAS holds 2147 km in whole millimetres, and these points lie farther apart</source><translation>o LAS abrange 2147 km em milímetros inteiros, e estes pontos estão mais afastados entre si</translation></message>
<message><source>save them as .pcd or .ply</source><translation>salve-os como .pcd ou .ply</translation></message>
<message><source>LASzip gives no reason</source><translation>o LASzip não dá motivo</translation></message>
<message><source>this LAZ file cannot be unpacked: %1</source><translation>este arquivo LAZ não pode ser descompactado: %1</translation></message>
<message><source>the header promises %1, more than a file of %2 holds of a scan</source><translation>o cabeçalho anuncia %1, mais do que um arquivo de %2 contém de uma varredura</translation></message>
<message><source>copy it again, or save it as .las</source><translation>copie-o de novo, ou salve-o como .las</translation></message>
<message><source>the header promises %1 and the file ends after %2 (%3)</source><translation>o cabeçalho anuncia %1 e o arquivo termina depois de %2 (%3)</translation></message>
<message><source>this LAZ file is damaged or cut off</source><translation>este arquivo LAZ está danificado ou cortado</translation></message>
<message><source>this LAZ file cannot be unpacked: </source><translation>este arquivo LAZ não pode ser descompactado: </translation></message>
<message><source>this LAZ file cannot be unpacked: it ends too early</source><translation>este arquivo LAZ não pode ser descompactado: termina cedo demais</translation></message>
<message><source>this LAS file is compressed (LAZ), and this build of the program was made without LASzip</source><translation>este arquivo LAS está comprimido (LAZ), e esta versão do programa foi compilada sem LASzip</translation></message>
<message><source>save it uncompressed as .las, with CloudCompare or "laszip -i IN.laz -o OUT.las"</source><translation>salve-o sem compressão como .las, com o CloudCompare ou "laszip -i IN.laz -o OUT.las"</translation></message>
<message><source>reading ranges</source><translation>leitura das distâncias</translation></message>
<message><source>the array at [%1, %2]</source><translation>a matriz em [%1, %2]</translation></message>
<message><source>The first three of %1 columns were taken as x, y and z; the others are not read.</source><translation>As três primeiras de %1 colunas foram tomadas como x, y e z; as outras não são lidas.</translation></message>
<message><source>the records of this numpy array have no x, y and z, only %1</source><translation>os registros desta matriz numpy não têm x, y e z, só %1</translation></message>
<message><source>save points with fields x, y and z</source><translation>salve os pontos com campos x, y e z</translation></message>
<message><source>the fields of this numpy array have different byte orders</source><translation>os campos desta matriz numpy têm ordens de bytes diferentes</translation></message>
<message><source>save it again with one</source><translation>salve-a de novo com uma só</translation></message>
<message><source>a numpy array of shape %1 is larger than any scan</source><translation>uma matriz numpy de forma %1 é maior que qualquer varredura</translation></message>
<message><source>split it</source><translation>divida-a</translation></message>
<message><source>a numpy array of shape %1 may be points the wrong way round, or three lines of ranges</source><translation>uma matriz numpy de forma %1 podem ser pontos com os eixos trocados, ou três linhas de distâncias</translation></message>
<message><source>save points as (n, 3), which is points.T, or give --beam-start --beam-step --line-start --line-step --axis</source><translation>salve os pontos como (n, 3), que é points.T, ou indique --beam-start --beam-step --line-start --line-step --axis</translation></message>
<message><source>a numpy array of shape %1 is neither ranges (lines, beams) nor points (n, 3) or (lines, beams, 3)</source><translation>uma matriz numpy de forma %1 não é nem distâncias (linhas, feixes) nem pontos (n, 3) ou (linhas, feixes, 3)</translation></message>
<message><source>save it in one of these shapes</source><translation>salve-a numa destas formas</translation></message>
<message><source>The file holds more than one array (numpy.save more than once); the first was read.</source><translation>O arquivo contém mais de uma matriz (numpy.save mais de uma vez); foi lida a primeira.</translation></message>
<message><source>the array</source><translation>a matriz</translation></message>
<message><source>Python objects, which only Python can open</source><translation>objetos de Python, que só o Python pode abrir</translation></message>
<message><source>true and false</source><translation>verdadeiro e falso</translation></message>
<message><source>complex numbers</source><translation>números complexos</translation></message>
<message><source>dates or times</source><translation>datas ou horas</translation></message>
<message><source>values of type %1</source><translation>valores do tipo %1</translation></message>
<message><source>save the array again with numpy.save</source><translation>salve de novo a matriz com numpy.save</translation></message>
<message><source>the file ends within its numpy header</source><translation>o arquivo termina dentro do seu cabeçalho numpy</translation></message>
<message><source>this is version %1 of numpy's format</source><translation>esta é a versão %1 do formato do numpy</translation></message>
<message><source>the numpy header does not say type, order and shape</source><translation>o cabeçalho numpy não diz tipo, ordem e forma</translation></message>
<message><source>the numpy header promises an array of shape %1</source><translation>o cabeçalho numpy anuncia uma matriz de forma %1</translation></message>
<message><source>this numpy array holds %1</source><translation>esta matriz numpy contém %1</translation></message>
<message><source>save it as an array of numbers (ranges.astype(numpy.float32))</source><translation>salve-a como matriz de números (ranges.astype(numpy.float32))</translation></message>
<message><source>this numpy array of shape %1 is empty</source><translation>esta matriz numpy de forma %1 está vazia</translation></message>
<message><source>the numpy header promises an array of shape %1, %2 of %3 bytes, and the file holds %4 bytes of them</source><translation>o cabeçalho numpy anuncia uma matriz de forma %1, %2 de %3 bytes, e o arquivo contém %4 bytes deles</translation></message>
<message><source>%n item</source><translation>%n elemento</translation></message>
<message><source>%n items</source><translation>%n elementos</translation></message>
<message><source>this vertex does not hold three numbers</source><translation>este vértice não contém três números</translation></message>
<message><source>copy the file again, it may be cut off here</source><translation>copie de novo o arquivo, ele pode estar cortado aqui</translation></message>
<message><source>this OBJ file has no vertices</source><translation>este arquivo OBJ não tem vértices</translation></message>
<message><source>%n line holds no words of OBJ and was not read, the first is line %1.</source><translation>%n linha não tem palavras de OBJ e não foi lida, a primeira é a linha %1.</translation></message>
<message><source>%n lines hold no words of OBJ and were not read, the first is line %1.</source><translation>%n linhas não têm palavras de OBJ e não foram lidas, a primeira é a linha %1.</translation></message>
<message><source>this header line of the PCD file is not understood</source><translation>esta linha do cabeçalho do arquivo PCD não é entendida</translation></message>
<message><source>compare it with a PCD file of version 0.7</source><translation>compare-o com um arquivo PCD de versão 0.7</translation></message>
<message><source>the PCD header has no DATA line</source><translation>o cabeçalho PCD não tem linha DATA</translation></message>
<message><source>the PCD header names %1 and gives %2, %3 and %4</source><translation>o cabeçalho PCD nomeia %1 e dá %2, %3 e %4</translation></message>
<message><source>%n field</source><translation>%n campo</translation></message>
<message><source>%n fields</source><translation>%n campos</translation></message>
<message><source>%n size</source><translation>%n tamanho</translation></message>
<message><source>%n sizes</source><translation>%n tamanhos</translation></message>
<message><source>%n type</source><translation>%n tipo</translation></message>
<message><source>%n types</source><translation>%n tipos</translation></message>
<message><source>%n count</source><translation>%n contagem</translation></message>
<message><source>%n counts</source><translation>%n contagens</translation></message>
<message><source>the header promises more points than any file holds</source><translation>o cabeçalho anuncia mais pontos do que qualquer arquivo contém</translation></message>
<message><source>the header promises %1 and %2 x %3 of them</source><translation>o cabeçalho anuncia %1 e %2 x %3 deles</translation></message>
<message><source>the field %1 has a type or size that PCD does not know</source><translation>o campo %1 tem um tipo ou um tamanho que o PCD não conhece</translation></message>
<message><source>one point would take more than a megabyte</source><translation>um ponto ocuparia mais de um megabyte</translation></message>
<message><source>the PCD file has no fields x, y and z</source><translation>o arquivo PCD não tem campos x, y e z</translation></message>
<message><source>export the file with coordinates</source><translation>exporte o arquivo com coordenadas</translation></message>
<message><source>the file ends before its compressed points</source><translation>o arquivo termina antes dos seus pontos comprimidos</translation></message>
<message><source>promises %1 compressed bytes and holds %2</source><translation>anuncia %1 bytes comprimidos e contém %2</translation></message>
<message><source>promises that %1 unpack to %2, which no scan does</source><translation>anuncia que %1 se descompactam em %2, o que nenhuma varredura faz</translation></message>
<message><source>export the file again, uncompressed</source><translation>exporte de novo o arquivo, sem compressão</translation></message>
<message><source>the compressed points are damaged</source><translation>os pontos comprimidos estão danificados</translation></message>
<message><source>the points</source><translation>os pontos</translation></message>
<message><source>the encoding "%1" is not ascii, binary or binary_compressed</source><translation>a codificação «%1» não é ascii, binary nem binary_compressed</translation></message>
<message><source>this header line of the PLY file is not understood</source><translation>esta linha do cabeçalho do arquivo PLY não é entendida</translation></message>
<message><source>the PLY header has no end_header line</source><translation>o cabeçalho PLY não tem linha end_header</translation></message>
<message><source>the file ends before its vertices</source><translation>o arquivo termina antes dos seus vértices</translation></message>
<message><source>the header promises %1</source><translation>o cabeçalho anuncia %1</translation></message>
<message><source>check the file</source><translation>verifique o arquivo</translation></message>
<message><source>the PLY file has no vertices</source><translation>o arquivo PLY não tem vértices</translation></message>
<message><source>The lists that each vertex of this file has were not read.</source><translation>As listas que cada vértice deste arquivo tem não foram lidas.</translation></message>
<message><source>the header promises %1 and the file ends after %2</source><translation>o cabeçalho anuncia %1 e o arquivo termina depois de %2</translation></message>
<message><source>%n vertex</source><translation>%n vértice</translation></message>
<message><source>%n vertices</source><translation>%n vértices</translation></message>
<message><source>the format "%1" is none that PLY knows</source><translation>o PLY não conhece o formato «%1»</translation></message>
<message><source>the header promises %1 and the file holds %2 bytes of them</source><translation>o cabeçalho anuncia %1 e o arquivo contém %2 bytes deles</translation></message>
<message><source>the file is cut off in its last vertex</source><translation>o arquivo está cortado no seu último vértice</translation></message>
<message><source>Each vertex has a byte that the header does not name, as PCL writes it behind colours: it was skipped.</source><translation>Cada vértice tem um byte que o cabeçalho não nomeia, como o PCL o escreve depois das cores: foi saltado.</translation></message>
<message><source>the vertices have no x, y and z</source><translation>os vértices não têm x, y e z</translation></message>
<message><source>Only the vertices were read, not what follows them: %1.</source><translation>Só os vértices foram lidos, não o que vem depois: %1.</translation></message>
<message><source>say which columns are easting (x), northing (y) and elevation (z), by number or name: --columns 2,1,3</source><translation>diga quais colunas são este (x), norte (y) e elevação (z), por número ou nome: --columns 2,1,3</translation></message>
<message><source>--columns %1 does not name three different ones of its %2%3</source><translation>--columns %1 não nomeia três diferentes das suas %2%3</translation></message>
<message><source>give three numbers from 1, or three names, such as --columns 2,1,3</source><translation>dê três números a partir de 1, ou três nomes, como --columns 2,1,3</translation></message>
<message><source>holds %1 where a point needs three</source><translation>contém %1 onde um ponto precisa de três</translation></message>
<message><source>%n number</source><translation>%n número</translation></message>
<message><source>%n numbers</source><translation>%n números</translation></message>
<message><source>choose a point list or a table of ranges</source><translation>escolha uma lista de pontos ou uma tabela de distâncias</translation></message>
<message><source>its heading names %1 (%2), and points need x, y and z in metres</source><translation>seu título nomeia %1 (%2), e os pontos precisam de x, y e z em metros</translation></message>
<message><source>write x, y and z, or ranges as a table with a row per scan line; or </source><translation>escreva x, y e z, ou distâncias como tabela com uma fileira por linha; ou </translation></message>
<message><source>its heading names axes (%1), and not all of x, y and z are understood</source><translation>o seu cabeçalho nomeia eixos (%1), e nem todos os x, y e z são entendidos</translation></message>
<message><source>its heading names no x, y and z that are understood (%1)</source><translation>o seu cabeçalho não nomeia x, y e z que se entendam (%1)</translation></message>
<message><source>the second to the fourth</source><translation>da segunda à quarta</translation></message>
<message><source>the third to the fifth</source><translation>da terceira à quinta</translation></message>
<message><source>the fourth to the sixth</source><translation>da quarta à sexta</translation></message>
<message><source>the fifth to the seventh</source><translation>da quinta à sétima</translation></message>
<message><source>the first holds</source><translation>a primeira contém</translation></message>
<message><source>the first two hold</source><translation>as duas primeiras contêm</translation></message>
<message><source>the first three hold</source><translation>as três primeiras contêm</translation></message>
<message><source>the first four hold</source><translation>as quatro primeiras contêm</translation></message>
<message><source>No heading names the columns: the first two were taken for row and column of the grid, the third to the fifth for x, y and z.</source><translation>Nenhum cabeçalho nomeia as colunas: as duas primeiras foram tomadas como fileira e coluna da grade, da terceira à quinta como x, y e z.</translation></message>
<message><source>No heading names the columns: %1 were taken for x, y and z, as %2 whole numbers only.</source><translation>Nenhum título nomeia as colunas: como x, y e z foram tomadas %1, pois %2 só números inteiros.</translation></message>
<message><source>The header names no x, y and z: the first three columns were taken for them (%1, %2, %3).</source><translation>O cabeçalho não nomeia x, y nem z: foram tomadas as três primeiras colunas (%1, %2, %3).</translation></message>
<message><source>The heading does not name as many columns as there are (%1): the first three were taken for x, y and z.</source><translation>O cabeçalho não nomeia tantas colunas quantas há (%1): as três primeiras foram tomadas como x, y e z.</translation></message>
<message><source>this is neither text nor any scan format that is known</source><translation>isto não é texto nem um formato de varredura conhecido</translation></message>
<message><source>begins a further list, behind the %1 of the first</source><translation>começa outra lista, depois dos %1 da primeira</translation></message>
<message><source>save each scan in a file of its own</source><translation>salve cada varredura num arquivo próprio</translation></message>
<message><source>holds %1 where a point needs %2</source><translation>contém %1 onde um ponto precisa de %2</translation></message>
<message><source>the file may be cut off here, copy it again</source><translation>o arquivo pode estar cortado aqui, copie-o de novo</translation></message>
<message><source>promises %1 and holds %2</source><translation>anuncia %1 e contém %2</translation></message>
<message><source>scan %1 of this PTX file promises %2 of %3, and the file ends before them</source><translation>a varredura %1 deste arquivo PTX anuncia %2 de %3, e o arquivo termina antes</translation></message>
<message><source>behind the %1 of %2 that the header promises there are more</source><translation>depois dos %1 de %2 que o cabeçalho anuncia há mais</translation></message>
<message><source>scan %1 has no PTX header here</source><translation>a varredura %1 não tem cabeçalho PTX aqui</translation></message>
<message><source>the scan of this PTX file holds 0 points</source><translation>a varredura deste arquivo PTX contém 0 pontos</translation></message>
<message><source>the %1 scans of this PTX file hold 0 points</source><translation>as %1 varreduras deste arquivo PTX contêm 0 pontos</translation></message>
<message><source>the header promises %1 and the file holds %2</source><translation>o cabeçalho anuncia %1 e o arquivo contém %2</translation></message>
<message><source>The matrix of the header has the scanner's place in its last column and not in its last row: it was read by columns.</source><translation>A matriz do cabeçalho tem o lugar do scanner na última coluna e não na última fileira: foi lida por colunas.</translation></message>
<message><source>Lines 4 to 6 of the header turn the scanner to another side than its matrix: the matrix was used.</source><translation>As linhas 4 a 6 do cabeçalho giram o scanner para outro lado que a sua matriz: a matriz foi usada.</translation></message>
<message><source>Line 3 of the header puts the scanner %1 m from the place that its matrix gives: the matrix was used.</source><translation>A linha 3 do cabeçalho põe o scanner a %1 m do lugar que a sua matriz dá: foi usada a matriz.</translation></message>
<message><source>Behind the last of these scans there is text that is none.</source><translation>Depois da última destas varreduras há texto que não é uma.</translation></message>
<message><source>PTX holds one point per cell, and points behind the nearest of their cell were asked for</source><translation>o PTX contém um ponto por célula, e foram pedidos também os pontos atrás do mais próximo de sua célula</translation></message>
<message><source>use .pcd, .ply, .csv, .xyz, .las or .obj for them</source><translation>use para eles .pcd, .ply, .csv, .xyz, .las ou .obj</translation></message>
<message><source>column %1 holds %2, so this is not a table of ranges</source><translation>a coluna %1 contém %2, então isto não é uma tabela de distâncias</translation></message>
<message><source>for a list of points call its columns x, y and z in a first row, and leave out --beam-step and --line-step</source><translation>para uma lista de pontos chame suas colunas de x, y e z numa primeira linha, e deixe de fora --beam-step e --line-step</translation></message>
<message><source>; or save it with a row per scan line: it has as many rows as an LMS511 has beams</source><translation>; ou salve-a com uma fileira por linha: tem tantas fileiras quantos feixes um LMS511</translation></message>
<message><source>holds %1 where the first line holds %2</source><translation>contém %1 onde a primeira linha contém %2</translation></message>
<message><source>%n range</source><translation>%n distância</translation></message>
<message><source>%n ranges</source><translation>%n distâncias</translation></message>
<message><source>copy or export the file again</source><translation>copie ou exporte de novo o arquivo</translation></message>
<message><source>%n column is not ranges, by the header, and not read: %1.</source><translation>%n coluna não é de distâncias, segundo o cabeçalho, e não foi lida: %1.</translation></message>
<message><source>%n columns are not ranges, by the header, and not read: %1.</source><translation>%n colunas não são de distâncias, segundo o cabeçalho, e não foram lidas: %1.</translation></message>
<message><source>The angles of the beams were taken from the header: %1 to %2 degrees.</source><translation>Os ângulos dos feixes foram tomados do cabeçalho: de %1 a %2 graus.</translation></message>
<message><source>The angles of the lines were taken from the first column: %1 to %2 degrees.</source><translation>Os ângulos das linhas foram tomados da primeira coluna: de %1 a %2 graus.</translation></message>
<message><source>Unit taken from a comment of the file: %1 mm per number.</source><translation>Unidade tomada de um comentário do arquivo: %1 mm por unidade.</translation></message>
<message><source>line %1, beam %2</source><translation>linha %1, feixe %2</translation></message>
<message><source> infinite ranges were taken as no return.</source><translation> distâncias infinitas foram tomadas como sem retorno.</translation></message>
<message><source> ranges below 0, all the same number, were taken as no return.</source><translation> distâncias abaixo de 0, todas o mesmo número, foram tomadas como sem retorno.</translation></message>
<message><source> ranges longer than any scanner reaches were taken as no return.</source><translation> distâncias mais longas que o alcance de qualquer scanner foram tomadas como sem retorno.</translation></message>
<message><source>%1 holds %2, which is not a range</source><translation>%1 contém %2, que não é uma distância</translation></message>
<message><source>check that these are ranges; points need columns x, y and z</source><translation>verifique se são distâncias; os pontos precisam de colunas x, y e z</translation></message>
<message><source>cells hold %1 in the numbers of the file</source><translation>células contêm %1 nos números do arquivo</translation></message>
<message><source>give %1</source><translation>indique %1</translation></message>
<message><source>: those of an LMS511 were taken where none were given (beams from -5 degrees by 1/6 degree, lines from 0 by 0.18 degree, axis spin).</source><translation>: onde não foram dados, foram tomados os de um LMS511 (feixes desde -5 graus a cada 1/6 de grau, linhas desde 0 a cada 0.18 graus, eixo spin).</translation></message>
<message><source>The ranges reach %1 km: check %2.</source><translation>As distâncias chegam a %1 km: verifique %2.</translation></message>
<message><source>All ranges are below 100 mm, so they may be metres: check %1.</source><translation>Todas as distâncias estão abaixo de 100 mm, portanto podem ser metros: verifique %1.</translation></message>
<message><source>All %1 lines are at one angle: check the step from line to line.</source><translation>Todas as %1 linhas estão em um só ângulo: verifique o passo de linha a linha.</translation></message>
<message><source>a table of %1 per line does not say its angles</source><translation>uma tabela de %1 por linha não diz seus ângulos</translation></message>
<message><source>The table does not say its angles</source><translation>A tabela não diz seus ângulos</translation></message>
<message><source>a picture of %1 per line does not say its angles</source><translation>uma imagem de %1 por linha não diz seus ângulos</translation></message>
<message><source>The picture does not say its angles</source><translation>A imagem não diz seus ângulos</translation></message>
<message><source>a numpy array of %1 per line does not say its angles</source><translation>uma matriz numpy de %1 por linha não diz seus ângulos</translation></message>
<message><source>The numpy array does not say its angles</source><translation>A matriz numpy não diz seus ângulos</translation></message>
<message><source>%1 lines x %2 beams</source><translation>%1 linhas x %2 feixes</translation></message>
<message><source>holds %1 bytes where %2 need %3</source><translation>contém %1 bytes onde %2 precisam de %3</translation></message>
<message><source>check lines and beams in the .json file</source><translation>verifique linhas e feixes no arquivo .json</translation></message>
<message><source>"beam_deg" is missing</source><translation>falta "beam_deg"</translation></message>
<message><source>"line_deg" is missing</source><translation>falta "line_deg"</translation></message>
<message><source>"axis" is missing</source><translation>falta "axis"</translation></message>
<message><source>add it to the .json file, or give --beam-start --beam-step --line-start --line-step --axis</source><translation>acrescente-o ao arquivo .json, ou indique --beam-start --beam-step --line-start --line-step --axis</translation></message>
<message><source>"%1" is not a key of a raw grid and was not used: check its spelling.</source><translation>"%1" não é uma chave de uma grade bruta e não foi usada: verifique a ortografia.</translation></message>
<message><source>the file names the counts of missing returns</source><translation>o arquivo indica as contagens dos retornos ausentes</translation></message>
<message><source>The data file %1 is missing; %2 was read in its place.</source><translation>Falta o arquivo de dados %1; em seu lugar foi lido %2.</translation></message>
<message><source>counts alone are not a raw grid</source><translation>contagens sozinhas não são uma grade bruta</translation></message>
<message><source>give the description before them</source><translation>dê a descrição antes delas</translation></message>
<message><source>these counts need their description %1 next to them, and it cannot be read</source><translation>estes valores precisam da sua descrição %1 ao lado, e ela não pode ser lida</translation></message>
<message><source>copy it into the same folder</source><translation>copie-a para a mesma pasta</translation></message>
<message><source>save it as PCD, which carries every scan</source><translation>salve-a como PCD, que admite qualquer varredura</translation></message>
<message><source>a raw grid needs beam and line angles and this cloud has none</source><translation>uma grade bruta precisa de ângulos de feixes e de linhas e esta nuvem não os tem</translation></message>
<message><source>a raw grid holds whole counts of its unit up to 65535, and the range at %1 is none or means no return</source><translation>uma grade bruta contém contagens inteiras de sua unidade até 65535, e a distância em %1 não é uma ou significa sem retorno</translation></message>
<message><source>%1, and %2</source><translation>%1, e %2</translation></message>
<message><source>a point of a string needs its number, northing, easting and elevation</source><translation>um ponto de uma cadeia precisa de seu número, norte, este e elevação</translation></message>
<message><source>copy the file again, it may be cut off or damaged here</source><translation>copie de novo o arquivo, ele pode estar cortado ou danificado aqui</translation></message>
<message><source>a Surpac string file is text, and this is none</source><translation>um arquivo de cadeias do Surpac é texto, e este não é</translation></message>
<message><source>Surpac strings</source><translation>Linhas do Surpac</translation></message>
<message><source>this Surpac file has no points</source><translation>este arquivo Surpac não tem pontos</translation></message>
<message><source>The file does not end with END: it may have been cut off; compare it with the original.</source><translation>O arquivo não termina com END: pode estar cortado; compare-o com o original.</translation></message>
<message><source>Descriptions of points (D1 and further) are not read.</source><translation>As descrições dos pontos (D1 e seguintes) não são lidas.</translation></message>
<message><source>%n line behind END was not read.</source><translation>%n linha depois de END não foi lida.</translation></message>
<message><source>%n lines behind END were not read.</source><translation>%n linhas depois de END não foram lidas.</translation></message>
<message><source>open the scan as the scanner stored it, or with its record</source><translation>abra a varredura tal como o scanner a gravou, ou com o seu registro</translation></message>
<message><source>finding the axis</source><translation>busca do eixo</translation></message>
<message><source>they do not follow each other in scan lines that turn about an axis elsewhere</source><translation>não se seguem em linhas que giram em torno de um eixo noutro lugar</translation></message>
<message><source>Each line has every %1th beam only, in turn: %2 lines that follow each other were put side by side.</source><translation>Cada linha só tem um feixe em cada %1, por turno: %2 linhas seguidas foram postas lado a lado.</translation></message>
<message><source>the %1 points do not lie on beam x line angles about the origin:</source><translation>os %1 pontos não estão em ângulos feixe x linha em torno da origem:</translation></message>
<message><source>about %1 no scan lines can be recognised</source><translation>em torno de %1 não se reconhecem linhas de varredura</translation></message>
<message><source>about %1 %2 % lie on the best %3</source><translation>em torno de %1 %2 % estão nos melhores %3</translation></message>
<message><source>%n line angles</source><translation>%n ângulos de linha</translation></message>
<message><source>%n beam angles</source><translation>%n ângulos de feixe</translation></message>
<message><source> (99 % are needed)</source><translation> (são precisos 99 %)</translation></message>
<message><source>The list was not a full grid in order: %1 lines x %2 beams were recovered from the angles of its points.</source><translation>A lista não era uma grade completa em ordem: %1 linhas x %2 feixes foram recuperados a partir dos ângulos dos seus pontos.</translation></message>
<message><source> lines repeated the line before and were left out.</source><translation> linhas repetiam a linha anterior e foram deixadas de fora.</translation></message>
<message><source> points stood in the list before, as when a driver stores lines twice, and were taken once.</source><translation> pontos já estavam na lista, como quando um driver grava linhas duas vezes, e foram tomados uma vez.</translation></message>
<message><source> lines or beams without any point were put back empty, to keep the steps even.</source><translation> linhas ou feixes sem nenhum ponto foram repostos vazios, para manter passos iguais.</translation></message>
<message><source> points belong to no single cell of the grid (on the rotation axis, or off the grid) and were left out.</source><translation> pontos não pertencem a uma única célula da grade (no eixo de rotação, ou fora da grade) e foram deixados de fora.</translation></message>
<message><source> points lay in a cell with a nearer one, which was taken.</source><translation> pontos estavam numa célula com um mais próximo, que foi tomado.</translation></message>
<message><source>The line angles are uneven: steps from %1 to %2 degrees, kept as they are.</source><translation>Os ângulos das linhas são desiguais: passos de %1 a %2 graus, mantidos como estão.</translation></message>
<message><source>The lines turn about the file's y axis, which became z: x is the file's z, y its x, z its y.</source><translation>As linhas giram em torno do eixo y do arquivo, que passou a z: x é o z do arquivo, y o seu x, z o seu y.</translation></message>
<message><source>holds %1 with a return, too few to find a scanner's grid</source><translation>contém %1 com retorno, poucos demais para encontrar a grade de um scanner</translation></message>
<message><source>check that the file is complete</source><translation>verifique se o arquivo está completo</translation></message>
<message><source>holds more points than can be put on a grid</source><translation>contém mais pontos do que cabem numa grade</translation></message>
<message><source>split the file</source><translation>divida o arquivo</translation></message>
<message><source>finding the grid</source><translation>busca da grade</translation></message>
<message><source>open the scan as the scanner stored it, with its origin at the scanner</source><translation>abra a varredura tal como o scanner a gravou, com a origem no scanner</translation></message>
<message><source>%1 x %2 degrees</source><translation>%1 x %2 graus</translation></message>
<message><source>cells of %1 degrees over %2 would be %3 million cells</source><translation>células de %1 graus sobre %2 seriam %3 milhões de células</translation></message>
<message><source>give a larger --grid-step</source><translation>indique um --grid-step maior</translation></message>
<message><source>all %1 points lie in one direction from there, within %2 and %3 to %4 away</source><translation>os %1 pontos estão todos numa só direção a partir dali, dentro de %2 e a %3 a %4</translation></message>
<message><source>%n point in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells around a filled one %6 %), %7 attached to a cell with a nearer one</source><translation>%n ponto incluído, visto sobre %1 x %2 graus; %3 de %4 células preenchidas (taxa de preenchimento %5 %; das células em torno de uma preenchida %6 %), %7 atribuído a uma célula com outro mais próximo</translation></message>
<message><source>%n points in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells around a filled one %6 %), %7 attached to a cell with a nearer one</source><translation>%n pontos incluídos, vistos sobre %1 x %2 graus; %3 de %4 células preenchidas (taxa de preenchimento %5 %; das células em torno de uma preenchida %6 %), %7 atribuídos a uma célula com outro mais próximo</translation></message>
<message><source>%n point far from all others left out</source><translation>%n ponto longe de todos os outros deixado de fora</translation></message>
<message><source>%n points far from all others left out</source><translation>%n pontos longe de todos os outros deixados de fora</translation></message>
<message><source>a grid step of %1 degrees makes no grid</source><translation>um passo de grade de %1 graus não dá grade</translation></message>
<message><source>give --grid-step between 0 and 45 degrees</source><translation>indique --grid-step entre 0 e 45 graus</translation></message>
<message><source>only %1 a return, too few to make a grid of them</source><translation>só %1 retorno, poucos demais para fazer uma grade</translation></message>
<message><source>%n point has</source><translation>%n ponto tem</translation></message>
<message><source>%n points have</source><translation>%n pontos têm</translation></message>
<message><source>projecting the points</source><translation>projeção dos pontos</translation></message>
<message><source>seen from there the points make no picture: %1</source><translation>vistos dali os pontos não formam uma imagem: %1</translation></message>
<message><source>give a larger --grid-step, or another --sensor</source><translation>indique um --grid-step maior, ou outro --sensor</translation></message>
<message><source>The file lists only points: </source><translation>O arquivo contém só pontos: </translation></message>
<message><source>give --sensor X,Y,Z, the place in metres that the scan was taken from</source><translation>indique --sensor X,Y,Z,, o lugar em metros de onde a varredura foi feita</translation></message>
<message><source>Unit taken as millimetres</source><translation>Unidade tomada como milímetros</translation></message>
<message><source>Unit taken as centimetres</source><translation>Unidade tomada como centímetros</translation></message>
<message><source>Unit taken as metres</source><translation>Unidade tomada como metros</translation></message>
<message><source>Ranges beyond 1,000 m: if the file is in millimetres, give --unit mm.</source><translation>Distâncias acima de 1000 m: se o arquivo estiver em milímetros, indique --unit mm.</translation></message>
<message><source>, in which every range is a whole number of millimetres.</source><translation>, unidade em que cada distância é um número inteiro de milímetros.</translation></message>
<message><source>, from the size of the numbers.</source><translation>, pelo tamanho dos números.</translation></message>
<message><source>a recording is being written already</source><translation>uma gravação já está em andamento</translation></message>
<message><source>stop it first</source><translation>pare-a primeiro</translation></message>
<message><source> ranges are range_min or range_max of their messages, repeat, and were taken as no return.</source><translation> distâncias são o range_min ou o range_max das suas mensagens, repetem-se e foram tomadas como sem retorno.</translation></message>
<message><source>no return </source><translation>sem retorno </translation></message>
<message><source>sweep complete</source><translation>varredura completa</translation></message>
<message><source>sweep ended</source><translation>varredura terminada</translation></message>
<message><source>window clean</source><translation>janela limpa</translation></message>
<message><source> earlier in this sweep</source><translation> antes nesta varredura</translation></message>
<message><source> scan telegrams since the start could not be decoded, so their lines are lost: </source><translation> telegramas de varredura desde o início não puderam ser decodificados, portanto as suas linhas estão perdidas: </translation></message>
<message><source> bytes since the start were not a telegram and were skipped.</source><translation> bytes desde o início não eram um telegrama e foram saltados.</translation></message>
<message><source>The sweep has ended; no line has come since.</source><translation>A varredura terminou; nenhuma linha chegou desde então.</translation></message>
<message><source>device ok</source><translation>aparelho em ordem</translation></message>
<message><source>DEVICE ERROR earlier in this sweep</source><translation>ERRO DO APARELHO antes nesta varredura</translation></message>
<message><source>pose of unknown age</source><translation>pose de idade desconhecida</translation></message>
<message><source>beam %1 of %2 would be at %3 degrees</source><translation>o feixe %1 de %2 estaria a %3 graus</translation></message>
<message><source>line %1 of %2 would be at %3 degrees</source><translation>a linha %1 de %2 estaria a %3 graus</translation></message>
<message><source>give angles from %1 to %2 degrees</source><translation>indique ângulos de %1 a %2 graus</translation></message>
<message><source>a calibration alone gives no place</source><translation>uma calibração sozinha não dá um lugar</translation></message>
<message><source>give --pose POSE.json too</source><translation>indique também --pose POSE.json</translation></message>
<message><source>the format %1 does not have it</source><translation>o formato %1 não o tem</translation></message>
<message><source>%1 points lie farther than %2 from the sensor and were taken as no return: --sensor X,Y,Z says where it stood.</source><translation>%1 pontos estão a mais de %2 do sensor e foram tomados como sem retorno: --sensor X,Y,Z diz onde ele estava.</translation></message>
<message><source>%1 cannot be a measured %2: %3 to %4</source><translation>%1 não pode ser um valor medido de %2: de %3 a %4</translation></message>
<message><source>%1 at %5 cannot be a measured %2: %3 to %4</source><translation>%1 em %5 não pode ser um valor medido de %2: de %3 a %4</translation></message>
<message><source>check the unit and the numbers of the file</source><translation>verifique a unidade e os números do arquivo</translation></message>
<message><source>beam %1</source><translation>feixe %1</translation></message>
<message><source>line %1</source><translation>linha %1</translation></message>
<message><source>the skew of beam %1</source><translation>a defasagem do feixe %1</translation></message>
<message><source>all %1 beams look the same way</source><translation>os %1 feixes olham todos na mesma direção</translation></message>
<message><source>give the step from beam to beam</source><translation>indique o passo de feixe a feixe</translation></message>
<message><source>all points are within %1 m of each other and at least %2 m away from the scanner, which no scanner measures</source><translation>todos os pontos estão a menos de %1 m uns dos outros e a pelo menos %2 m do scanner, o que nenhum scanner mede</translation></message>
<message><source>give --sensor X,Y,Z, the place in metres that the scan was taken from, or check --unit</source><translation>indique --sensor X,Y,Z, o lugar em metros de onde a varredura foi feita, ou verifique --unit</translation></message>
<message><source>The sensor's place was found from the ranges that the file holds with its points.</source><translation>O lugar do sensor foi encontrado a partir das distâncias que o arquivo contém com os seus pontos.</translation></message>
<message><source>The columns of lines and beams hold no grid and were not used.</source><translation>As colunas de linhas e feixes não contêm nenhuma grade e não foram usadas.</translation></message>
<message><source>too few points</source><translation>pontos de menos</translation></message>
<message><source>left-handed points</source><translation>pontos de mão esquerda</translation></message>
<message><source>their scan lines turn about another axis than --axis says</source><translation>suas linhas de varredura giram em torno de outro eixo que o de --axis</translation></message>
<message><source>their scan lines turn about an axis through the origin</source><translation>suas linhas de varredura giram em torno de um eixo pela origem</translation></message>
<message><source>another grid</source><translation>outra grade</translation></message>
<message><source>about the axis of their scan lines they are on no common beams</source><translation>em torno do eixo de suas linhas de varredura não estão em feixes comuns</translation></message>
<message><source>Lines and beams were exchanged: only that way the lines make fans about one axis.</source><translation>Linhas e feixes foram trocados: só assim as linhas formam leques em torno de um eixo.</translation></message>
<message><source>The rows of the file make no fans about one axis as they are stored: %1, and only that way the lines make fans.</source><translation>As fileiras do arquivo, tal como estão, não formam leques em torno de um eixo: %1, e só assim as linhas formam leques.</translation></message>
<message><source>they were taken as beams, and the columns as lines</source><translation>foram tomadas como feixes, e as colunas como linhas</translation></message>
<message><source>its counts of rows and columns were exchanged</source><translation>seus números de linhas e colunas foram trocados</translation></message>
<message><source>its points were taken row by row, where the header says column by column</source><translation>seus pontos foram tomados linha por linha, onde o cabeçalho diz coluna por coluna</translation></message>
<message><source>No cell of this scan has a range that was measured: check the file, the topic and the limits of the range.</source><translation>Nenhuma célula desta varredura tem uma distância medida: verifique o arquivo, o tópico e os limites de distância.</translation></message>
<message><source>this folder holds several scans</source><translation>esta pasta contém várias varreduras</translation></message>
<message><source>open one of them, or use edgescan-cli batch</source><translation>abra uma delas, ou use edgescan-cli batch</translation></message>
<message><source>The pose in %1 replaces that in %2.</source><translation>A pose de %1 substitui a de %2.</translation></message>
<message><source>The folder holds %1 besides this recording: name one file, or use edgescan-cli batch.</source><translation>A pasta contém %1 além desta gravação: indique um arquivo, ou use edgescan-cli batch.</translation></message>
<message><source>%n scan</source><translation>%n varredura</translation></message>
<message><source>%n scans</source><translation>%n varreduras</translation></message>
<message><source>a cell has the state %1, which does not exist</source><translation>uma célula tem o estado %1, que não existe</translation></message>
<message><source>describes %1 and holds %2</source><translation>descreve %1 e contém %2</translation></message>
<message><source>describes %1 but has no columns range_mm and state</source><translation>descreve %1 mas não tem as colunas range_mm e state</translation></message>
<message><source>save the scan again, or remove the comment lines</source><translation>salve de novo a varredura, ou remova as linhas de comentário</translation></message>
<message><source>--unit does not apply: this program saved the file, in metres</source><translation>--unit não se aplica: este programa salvou o arquivo, em metros</translation></message>
<message><source>leave --unit out</source><translation>deixe --unit de fora</translation></message>
<message><source>a valid cell has a number that is not a range</source><translation>uma célula válida tem um número que não é uma distância</translation></message>
<message><source>the description in the comment lines has no angles</source><translation>a descrição nas linhas de comentário não tem ângulos</translation></message>
<message><source>%n point was filled and not measured, as filled_sd_mm says: it was taken as no return.</source><translation>%n ponto foi preenchido e não medido, como diz filled_sd_mm: foi tomado como sem retorno.</translation></message>
<message><source>%n points were filled and not measured, as filled_sd_mm says: they were taken as no return.</source><translation>%n pontos foram preenchidos e não medidos, como diz filled_sd_mm: foram tomados como sem retorno.</translation></message>
<message><source>the file gives the grid of its cells</source><translation>o arquivo dá a grade de suas células</translation></message>
<message><source>The matrix of the %1 file was not used: its points are in another frame than the scanner's.</source><translation>A matriz do arquivo %1 não foi usada: os seus pontos estão noutro referencial que o do scanner.</translation></message>
<message><source>%1 cells hold status codes of an LMS2xx from %2 on instead of a range and were taken as such.</source><translation>%1 células contêm códigos de estado de um LMS2xx a partir de %2 em vez de uma distância e foram tomadas como tais.</translation></message>
<message><source>The coordinates are rounded, and every point fits a whole number of millimetres along its beam: these were taken as ranges.</source><translation>As coordenadas estão arredondadas e cada ponto cai num número inteiro de milímetros ao longo do seu feixe: estes foram tomados como distâncias.</translation></message>
<message><source>The file's coordinates are left-handed and were turned right-handed: y is mirrored.</source><translation>As coordenadas do arquivo são levógiras e foram tornadas dextrógiras: y está espelhado.</translation></message>
<message><source>%1 of %2 cells of the grid that was found have no point and count as no return.</source><translation>%1 de %2 células da grade encontrada não têm ponto e contam como sem retorno.</translation></message>
<message><source>the origin, because no sensor position is known (--sensor X,Y,Z gives it)</source><translation>a origem, porque nenhuma posição do sensor é conhecida (--sensor X,Y,Z a dá)</translation></message>
<message><source>the sensor position given, (%1, %2, %3) m</source><translation>a posição do sensor indicada, (%1, %2, %3) m</translation></message>
<message><source>the sensor position in the file, (%1, %2, %3) m</source><translation>a posição do sensor no arquivo, (%1, %2, %3) m</translation></message>
<message><source>The points lie on no scanner grid and were projected about %1: %2.</source><translation>Os pontos não estão em nenhuma grade de scanner e foram projetados tomando como centro %1: %2.</translation></message>
<message><source>The points were projected about %1: %2.</source><translation>Os pontos foram projetados tomando como centro %1: %2.</translation></message>
<message><source>The cells have the given %1 degrees</source><translation>As células têm os %1 graus indicados</translation></message>
<message><source>The cells have %1 degrees, from the spacing of the points</source><translation>As células têm %1 graus, pelo espaçamento dos pontos</translation></message>
<message><source>, along lines that were recognised in the cloud.</source><translation>, ao longo de linhas que foram reconhecidas na nuvem.</translation></message>
<message><source>Edges of a projected cloud differ from those of its scan: a file with the points in the order of the scanner, or with its record, has the grid of the scan.</source><translation>As arestas de uma nuvem projetada diferem das da sua varredura: um arquivo com os pontos na ordem do scanner, ou com o seu registro, tem a grade da varredura.</translation></message>
<message><source>projected about %1: %2</source><translation>projetados tomando como centro %1: %2</translation></message>
<message><source>The axis of the scan lines is %1 (in the numbers of the file) from the sensor position that was known.</source><translation>O eixo das linhas da varredura está a %1 (nos números do arquivo) da posição conhecida do sensor.</translation></message>
<message><source>%n point is a later return of a pulse, as the file says: the first returns make the grid</source><translation>%n ponto é um retorno posterior de um pulso, segundo o arquivo: os primeiros retornos formam a grade</translation></message>
<message><source>%n points are later returns of a pulse, as the file says: the first returns make the grid</source><translation>%n pontos são retornos posteriores de um pulso, segundo o arquivo: os primeiros retornos formam a grade</translation></message>
<message><source>, and %1</source><translation>, e %1</translation></message>
<message><source>%n other was attached to its cell</source><translation>%n outro foi ligado à sua célula</translation></message>
<message><source>%n others were attached to their cells</source><translation>%n outros foram ligados às suas células</translation></message>
<message><source>%n other has no cell of its own and was left out</source><translation>%n outro não tem célula própria e foi deixado de fora</translation></message>
<message><source>%n others have no cell of their own and were left out</source><translation>%n outros não têm célula própria e foram deixados de fora</translation></message>
<message><source>%1 lines, %2 beams and mounting %3 were found from them.</source><translation>%1 linhas, %2 feixes e a montagem %3 foram encontrados a partir deles.</translation></message>
<message><source>--unit does not apply: the file holds ranges that give the unit of its points</source><translation>--unit não se aplica: o arquivo contém distâncias que dão a unidade de seus pontos</translation></message>
<message><source>the last scan line is not complete and the last row has no line end: the file was cut off</source><translation>a última linha da varredura está incompleta e a última fileira não tem fim de linha: o arquivo foi cortado</translation></message>
<message><source>the file is in another frame than the scanner's, and %1 of its points share their line and beam with another</source><translation>o arquivo está em outro referencial que o do scanner, e %1 de seus pontos compartilham linha e feixe com outro</translation></message>
<message><source>The grid has as many lines and beams as the points name, %1 x %2: a line or beam behind the last point is not in the file.</source><translation>A grade tem tantas linhas e feixes quantos os pontos nomeiam, %1 x %2: uma linha ou um feixe atrás do último ponto não está no arquivo.</translation></message>
<message><source>the points have a grid</source><translation>os pontos têm uma grade</translation></message>
<message><source>The list holds returns only: a line or beam at the border without any return is not in it.</source><translation>A lista só contém retornos: uma linha ou um feixe da borda sem nenhum retorno não está nela.</translation></message>
<message><source>points are one and the same,%1</source><translation>pontos são um e o mesmo,%1</translation></message>
<message><source>points are %1 (in the numbers of the file) from the sensor</source><translation>pontos estão a %1 (nos números do arquivo) do sensor</translation></message>
<message><source>its numbers are rounded to %1, and its points are within %2 of each other</source><translation>os seus números estão arredondados a %1, e os seus pontos distam entre si %2 no máximo</translation></message>
<message><source>write the coordinates again with all their decimals</source><translation>escreva de novo as coordenadas com todas as casas decimais</translation></message>
<message><source>its numbers were rounded to %1 digits, so that those near %2 step by %3: the digits that place the points are lost</source><translation>os seus números foram arredondados a %1 algarismos, e os próximos de %2 avançam em passos de %3: os algarismos que posicionam os pontos perderam-se</translation></message>
<message><source>write the coordinates again with all their decimals, as numbers and not in the form 1.23E+06</source><translation>escreva de novo as coordenadas com todas as casas decimais, como números e não na forma 1.23E+06</translation></message>
<message><source>%1 numbers per line without names are a table of ranges only with its angles; as points, %2</source><translation>%1 números por linha sem nomes são uma tabela de distâncias só com seus ângulos; como pontos, %2</translation></message>
<message><source>give --beam-start --beam-step --line-start --line-step --axis, or name the columns x, y and z</source><translation>indique --beam-start --beam-step --line-start --line-step --axis, ou nomeie as colunas x, y e z</translation></message>
<message><source>%1 of the %2 of the file have no cell of their own.</source><translation>%1 dos %2 do arquivo não têm célula própria.</translation></message>
<message><source>the file holds 0 points with a return, out of %1</source><translation>o arquivo contém 0 pontos com retorno, de %1</translation></message>
<message><source>choose another file, or copy it again</source><translation>escolha outro arquivo, ou copie-o de novo</translation></message>
<message><source>Numbers up to %1 in this file have a resolution of about %2: it was written with 4-byte floats.</source><translation>Neste arquivo, os números até %1 têm uma resolução de cerca de %2: foi escrito com números flutuantes de 4 bytes.</translation></message>
<message><source>%n point with infinite or absurdly large coordinates was taken as no return.</source><translation>%n ponto com coordenadas infinitas ou absurdamente grandes foi tomado como sem retorno.</translation></message>
<message><source>%n points with infinite or absurdly large coordinates were taken as no return.</source><translation>%n pontos com coordenadas infinitas ou absurdamente grandes foram tomados como sem retorno.</translation></message>
<message><source>the pose could not be removed (%1)</source><translation>não foi possível remover a pose (%1)</translation></message>
<message><source>remove the file by hand</source><translation>remova o arquivo à mão</translation></message>
<message><source>the file name has no extension that names a format</source><translation>o nome do arquivo não tem uma extensão que nomeie um formato</translation></message>
<message><source>"%1" is not a format that can be written</source><translation>«%1» não é um formato que possa ser escrito</translation></message>
<message><source>use %1</source><translation>use %1</translation></message>
<message><source>the edge mask has %1 x %2 cells and the scan %3 x %4</source><translation>a máscara de bordas tem %1 x %2 células e a varredura %3 x %4</translation></message>
<message><source>detect the edges of this scan again</source><translation>detecte de novo as bordas desta varredura</translation></message>
<message><source>the scan has no pose, so its place in the mine grid is not known</source><translation>a varredura não tem pose, portanto o seu lugar na grade da mina não é conhecido</translation></message>
<message><source>give a pose and the robot's calibration, or save in the scanner's frame</source><translation>dê uma pose e a calibração do robô, ou salve no referencial do scanner</translation></message>
<message><source>the scan has no cells</source><translation>a varredura não tem células</translation></message>
<message><source>a raw grid or a recording holds ranges and no coordinates</source><translation>uma grade bruta ou uma gravação contém distâncias e não coordenadas</translation></message>
<message><source>save it without a frame, or as %1</source><translation>salve-a sem referencial, ou como %1</translation></message>
<message><source>%n point behind the nearest of its cell is not in this file: --include-attached saves all points.</source><translation>%n ponto atrás do mais próximo de sua célula não está neste arquivo: --include-attached salva todos os pontos.</translation></message>
<message><source>%n points behind the nearest of their cell are not in this file: --include-attached saves all points.</source><translation>%n pontos atrás do mais próximo de sua célula não estão neste arquivo: --include-attached salva todos os pontos.</translation></message>
<message><source>The file holds points and no grid: %1 cells without a range are not in it.</source><translation>O arquivo contém pontos e nenhuma grade: %1 células sem distância não estão nele.</translation></message>
<message><source>This file knows only points and no returns: %1 cells of other states become no returns.</source><translation>Este arquivo só conhece pontos e células sem retorno: %1 células de outros estados passam a ser sem retorno.</translation></message>
<message><source>The file holds numbers only: keep %1.provenance.json next to it, which holds the grid, or write it with --comments.</source><translation>O arquivo contém só números: guarde junto dele %1.provenance.json, que contém a grade, ou escreva-o com --comments.</translation></message>
<message><source>The file does not hold the intensities: .pcd, .ply, .las, .ptx and .csv do.</source><translation>O arquivo não contém as intensidades: .pcd, .ply, .las, .ptx e .csv contêm.</translation></message>
<message><source>The file rounds the points to whole steps of %1 mm.</source><translation>O arquivo arredonda os pontos a passos inteiros de %1 mm.</translation></message>
<message><source>The file is in the scanner's frame and does not hold the scan's place in the mine: --frame mine gives mine coordinates.</source><translation>O arquivo está no referencial do scanner e não contém o lugar da varredura na mina: --frame mine dá coordenadas de mina.</translation></message>
<message><source>The file has room for one place of the scanner, and this scanner moved by up to %1 mm: without %2.provenance.json its ranges are as much off; its points are exact.</source><translation>O arquivo tem espaço para um lugar do scanner, e este scanner se moveu até %1 mm: sem %2.provenance.json suas distâncias diferem em igual medida; seus pontos são exatos.</translation></message>
<message><source>This file is an export of edge points, not a scan: all other cells count as no return. Open the scan to find edges.</source><translation>Este arquivo é uma exportação de pontos de aresta, não uma varredura: todas as outras células contam como sem retorno. Abra a varredura para procurar arestas.</translation></message>
<message><source>was written for another one</source><translation>foi escrito para outro</translation></message>
<message><source>describes no grid</source><translation>não descreve grade alguma</translation></message>
<message><source>does not list the cells of the points</source><translation>não enumera as células dos pontos</translation></message>
<message><source>has a grid for which there is not enough memory</source><translation>tem uma grade para a qual não há memória suficiente</translation></message>
<message><source>describes a grid without angles and without a sensor</source><translation>descreve uma grade sem ângulos e sem sensor</translation></message>
<message><source>lists other cells than the file has points</source><translation>enumera outras células que os pontos que o arquivo tem</translation></message>
<message><source>does not hold the place of the scan in the mine</source><translation>não contém o lugar da varredura na mina</translation></message>
<message><source>cannot be read (%1)</source><translation>não pode ser lido (%1)</translation></message>
<message><source>The record next to the file %1, so the grid in it was not used.</source><translation>O registro junto do arquivo não serve (%1), portanto a sua grade não foi usada.</translation></message>
<message><source>lists a cell twice</source><translation>enumera uma célula duas vezes</translation></message>
<message><source>The file puts the sensor %1 away from its points, which are all within %2 of each other (in its own numbers): no scanner measures so, and the place was not used.</source><translation>O arquivo põe o sensor a %1 dos seus pontos, que estão todos a menos de %2 uns dos outros (nos seus próprios números): nenhum scanner mede assim, e esse lugar não foi usado.</translation></message>
<message><source>the %1 points of its grid lie in one direction from the origin, within %2 degrees and up to %3 away: the scanner stood elsewhere</source><translation>os %1 pontos da sua grade estão numa só direção a partir da origem, dentro de %2 graus e até %3: o scanner estava noutro lugar</translation></message>
<message><source>Unit taken as metres, in which the numbers fit the sensor position given.</source><translation>O metro foi tomado como unidade, com o qual os números concordam com a posição do sensor indicada.</translation></message>
<message><source>Unit taken as millimetres, in which the numbers fit the sensor position given.</source><translation>O milímetro foi tomado como unidade, com o qual os números concordam com a posição do sensor indicada.</translation></message>
<message><source>numbers up to %1 in this file have a resolution of about %2</source><translation>os números até %1 deste arquivo têm uma resolução de cerca de %2</translation></message>
<message><source>The text has two bytes per character (UTF-16) and was read as such.</source><translation>O texto tem dois bytes por caractere (UTF-16) e foi lido assim.</translation></message>
<message><source>The text has four bytes per character (UTF-32) and was read as such.</source><translation>O texto tem quatro bytes por carácter (UTF-32) e foi lido assim.</translation></message>
<message><source>%n byte of zero (NUL) follows the last row, as a power cut leaves them: rows that were not written are missing.</source><translation>%n byte zero (NUL) segue a última fileira, como os deixa uma queda de energia: faltam as fileiras que não foram escritas.</translation></message>
<message><source>%n bytes of zero (NUL) follow the last row, as a power cut leaves them: rows that were not written are missing.</source><translation>%n bytes zero (NUL) seguem a última fileira, como os deixa uma queda de energia: faltam as fileiras que não foram escritas.</translation></message>
<message><source>the file holds only zeros (NUL), as a power cut leaves them</source><translation>o ficheiro só contém zeros (NUL), como os deixa um corte de energia</translation></message>
<message><source>copy it again from the scanner</source><translation>copie-o de novo do scanner</translation></message>
<message><source>The matrix in the file is not a rotation and shift, so the scan stays in the scanner's frame.</source><translation>A matriz do arquivo não é uma rotação e translação, portanto a varredura fica no referencial do scanner.</translation></message>
<message><source>The %1 file puts the scanner at %2, %3, %4 m, which is not a place on earth, so the scan stays in the scanner's frame.</source><translation>O arquivo %1 põe o scanner em %2, %3, %4 m, que não é um lugar na terra, portanto a varredura fica no referencial do scanner.</translation></message>
<message><source>as the %1 file has it</source><translation>como o tem o arquivo %1</translation></message>
<message><source>the header of %1</source><translation>o cabeçalho de %1</translation></message>
<message><source>The place is the one written in the %1 file: whether that is the mine grid, who registered it knows.</source><translation>O lugar é o escrito no arquivo %1: se isso é a grade da mina, sabe-o quem o registrou.</translation></message>
<message><source>The points are in another frame than the scanner's. Their scan lines turn about one axis, at %1, %2, %3 m, and the mirror is %4 off the axis</source><translation>Os pontos estão em outro referencial que o do scanner. Suas linhas de varredura giram em torno de um eixo, em %1, %2, %3 m, e o espelho está a %4 do eixo</translation></message>
<message><source>; the grid has the scale %1</source><translation>; a grade tem a escala %1</translation></message>
<message><source>%1. The points fit lines and beams within %2.</source><translation>%1. Os pontos encaixam em linhas e feixes com um erro de %2.</translation></message>
<message><source>That is more than the rounding of the numbers explains, %1 mm: ranges may be off, and edges may differ from those of the scan. The record of the file, or the scan as it was measured, has them exactly.</source><translation>É mais do que o arredondamento dos números explica, %1 mm: distâncias podem estar erradas e arestas diferir das da varredura. O registro do arquivo, ou a varredura tal como foi medida, tem-nas exatas.</translation></message>
<message><source>the scan lines of the points</source><translation>as linhas de varredura dos pontos</translation></message>
<message><source>The place was found from the scan lines of the points: whether their frame is the mine grid, the file does not say.</source><translation>O lugar foi encontrado a partir das linhas de varredura dos pontos: o arquivo não diz se o referencial deles é a grade da mina.</translation></message>
<message><source>copy the capture again</source><translation>copie de novo a captura</translation></message>
<message><source>the capture ends within its header</source><translation>a captura termina dentro do seu cabeçalho</translation></message>
<message><source>is too short for a packet</source><translation>é curto demais para um pacote</translation></message>
<message><source>names an interface that the capture does not describe</source><translation>nomeia uma interface que a captura não descreve</translation></message>
<message><source>promises more bytes of a packet than it has</source><translation>anuncia mais bytes de um pacote do que tem</translation></message>
<message><source>a block of this PCAPNG capture %1</source><translation>um bloco desta captura PCAPNG %1</translation></message>
<message><source>says that it has %1 bytes</source><translation>diz que tem %1 bytes</translation></message>
<message><source>is too short for an interface</source><translation>é curto demais para uma interface</translation></message>
<message><source>this is not a capture of network packets</source><translation>isto não é uma captura de pacotes de rede</translation></message>
<message><source>The capture was cut off: everything up to the cut is here.</source><translation>A captura foi cortada: tudo até o corte está aqui.</translation></message>
<message><source>%n packet has a time before 1970 or after 2262 and count as of 1970.</source><translation>%n pacote tem uma hora antes de 1970 ou depois de 2262 e conta como de 1970.</translation></message>
<message><source>%n packets have a time before 1970 or after 2262 and count as of 1970.</source><translation>%n pacotes têm uma hora antes de 1970 ou depois de 2262 e contam como de 1970.</translation></message>
<message><source>%n byte that the scanner sent is missing in the capture, in %1: the telegrams there are lost.</source><translation>%n byte que o scanner enviou falta na captura (%1): os telegramas ali estão perdidos.</translation></message>
<message><source>%n bytes that the scanner sent are missing in the capture, in %1: the telegrams there are lost.</source><translation>%n bytes que o scanner enviou faltam na captura (%1): os telegramas ali estão perdidos.</translation></message>
<message><source>%n place</source><translation>%n lugar</translation></message>
<message><source>%n places</source><translation>%n lugares</translation></message>
<message><source>%n byte that the scanner sent belongs to no whole telegram.</source><translation>%n byte que o scanner enviou não pertence a nenhum telegrama inteiro.</translation></message>
<message><source>%n bytes that the scanner sent belong to no whole telegram.</source><translation>%n bytes que o scanner enviou não pertencem a nenhum telegrama inteiro.</translation></message>
<message><source>%n packet came out of order and %1 brought bytes again; they were put in order.</source><translation>%n pacote chegou fora de ordem e %1 trouxeram bytes de novo; foram postos em ordem.</translation></message>
<message><source>%n packets came out of order and %1 brought bytes again; they were put in order.</source><translation>%n pacotes chegaram fora de ordem e %1 trouxeram bytes de novo; foram postos em ordem.</translation></message>
<message><source>%n fragment of IP packets were not put together.</source><translation>%n fragmento de pacotes IP não foi juntado.</translation></message>
<message><source>%n fragments of IP packets were not put together.</source><translation>%n fragmentos de pacotes IP não foram juntados.</translation></message>
<message><source>putting packets together</source><translation>junção dos pacotes</translation></message>
<message><source>this capture holds no scan telegram of a SICK scanner, and %1</source><translation>esta captura não contém telegrama de varredura de um scanner SICK, e %1</translation></message>
<message><source>this capture holds %1, %2 of them TCP, and no scan telegram of a SICK scanner and no packet of a VLP-16 or an Ouster</source><translation>esta captura contém %1, %2 deles TCP, e nenhum telegrama de varredura de um scanner SICK nem pacote de um VLP-16 ou de um Ouster</translation></message>
<message><source>%n packet</source><translation>%n pacote</translation></message>
<message><source>%n packets</source><translation>%n pacotes</translation></message>
<message><source>capture the connection to the scanner's port (2111 or 2112) while it scans</source><translation>capture a conexão à porta do scanner (2111 ou 2112) enquanto ele varre</translation></message>
<message><source>%n other sender has some too</source><translation>%n outro emissor também tem</translation></message>
<message><source>%n other senders have some too</source><translation>%n outros emissores também têm</translation></message>
<message><source>The capture holds %1 streams; that of %2 with %3 was opened, and %4.</source><translation>A captura contém %1 fluxos; foi aberto o de %2 com %3, e %4.</translation></message>
<message><source>The capture holds %1 streams; that of %2 with %3 was opened.</source><translation>A captura contém %1 fluxos; foi aberto o de %2 com %3.</translation></message>
<message><source>%n scan telegram</source><translation>%n telegrama de varredura</translation></message>
<message><source>%n scan telegrams</source><translation>%n telegramas de varredura</translation></message>
<message><source>finding telegrams</source><translation>busca de telegramas</translation></message>
<message><source>these are %1 of a SICK device and none is a scan</source><translation>estes são %1 de um aparelho SICK e nenhum é uma varredura</translation></message>
<message><source>%n telegram</source><translation>%n telegrama</translation></message>
<message><source>%n telegrams</source><translation>%n telegramas</translation></message>
<message><source>capture while the scanner sends scans (sEN LMDscandata 1)</source><translation>capture enquanto o scanner envia varreduras (sEN LMDscandata 1)</translation></message>
<message><source>CoLa stream</source><translation>Fluxo CoLa</translation></message>
<message><source>%n byte of the stream belongs to no whole telegram.</source><translation>%n byte do fluxo não pertence a nenhum telegrama inteiro.</translation></message>
<message><source>%n bytes of the stream belong to no whole telegram.</source><translation>%n bytes do fluxo não pertencem a nenhum telegrama inteiro.</translation></message>
<message><source>radians</source><translation>radianos</translation></message>
<message><source>hundredths of a degree</source><translation>centésimos de grau</translation></message>
<message><source>thousandths of a degree</source><translation>milésimos de grau</translation></message>
<message><source>milliradians</source><translation>milirradianos</translation></message>
<message><source>%1 (azimuth) and %2 (elevation)</source><translation>%1 (azimute) e %2 (elevação)</translation></message>
<message><source>angles in %1, azimuths %2</source><translation>ângulos em %1, azimutes %2</translation></message>
<message><source>angles taken as %1, azimuths %2</source><translation>ângulos tomados como %1, azimutes %2</translation></message>
<message><source>clockwise from y</source><translation>no sentido horário desde y</translation></message>
<message><source>counter-clockwise from x</source><translation>no sentido anti-horário desde x</translation></message>
<message><source>Points were computed from the columns of angles and ranges, with %1 and heights from the zenith.</source><translation>Os pontos foram calculados a partir das colunas de ângulos e distâncias, com %1 e alturas desde o zênite.</translation></message>
<message><source>Points were computed from the columns of angles and ranges, with %1.</source><translation>Os pontos foram calculados a partir das colunas de ângulos e distâncias, com %1.</translation></message>
<message><source>degrees of latitude and longitude</source><translation>graus de latitude e longitude</translation></message>
<message><source>angles and no ranges</source><translation>ângulos e não distâncias</translation></message>
<message><source>angles and ranges</source><translation>ângulos e distâncias</translation></message>
<message><source>two coordinates of a point and not the third</source><translation>duas coordenadas de um ponto e não a terceira</translation></message>
<message><source>compare it with docs/reference/formats.md, "Raw grid"</source><translation>compare-o com docs/reference/formats.md, "Raw grid"</translation></message>
<message><source>this is a drawing of rocks (GeoJSON) and not a scan</source><translation>isto é um desenho de rochas (GeoJSON) e não uma varredura</translation></message>
<message><source>open its scan</source><translation>abra sua varredura</translation></message>
<message><source>this is a preset and not a scan</source><translation>isto é uma predefinição e não uma varredura</translation></message>
<message><source>choose it in the panel Edges, or give it with --preset</source><translation>escolha-o no painel Bordas, ou indique-o com --preset</translation></message>
<message><source>this is a report of detect and not a scan</source><translation>isto é um relatório de detect e não uma varredura</translation></message>
<message><source>this is a report of rocks and not a scan</source><translation>isto é um relatório de rocks e não uma varredura</translation></message>
<message><source>this is a pose and not a scan</source><translation>isto é uma pose e não uma varredura</translation></message>
<message><source>open its scan and give it with --pose</source><translation>abra sua varredura e indique-o com --pose</translation></message>
<message><source>this is a calibration and not a scan</source><translation>isto é uma calibração e não uma varredura</translation></message>
<message><source>open its scan and give it with --calibration</source><translation>abra sua varredura e indique-o com --calibration</translation></message>
<message><source>this is a file of targets and not a scan</source><translation>isto é um arquivo de alvos e não uma varredura</translation></message>
<message><source>this is edits of rocks and not a scan</source><translation>isto é uma edição de rochas e não uma varredura</translation></message>
<message><source>open its scan, or give it with --edits</source><translation>abra sua varredura, ou indique-as com --edits</translation></message>
<message><source>this is a record of an export and not a scan</source><translation>isto é um registro de uma exportação e não uma varredura</translation></message>
<message><source>open its scan, or check it with edgescan-cli verify</source><translation>abra sua varredura, ou verifique-o com edgescan-cli verify</translation></message>
<message><source>must hold counts</source><translation>deve conter contagens</translation></message>
<message><source>holds %1, and there are %2</source><translation>contém %1, e há %2</translation></message>
<message><source>needs start and step</source><translation>precisa de start e step</translation></message>
<message><source>holds %1, %2 are needed</source><translation>contém %1, são necessários %2</translation></message>
<message><source>%n angle</source><translation>%n ângulo</translation></message>
<message><source>%n angles</source><translation>%n ângulos</translation></message>
<message><source>must be 1 or -1</source><translation>deve ser 1 ou -1</translation></message>
<message><source>must be a list</source><translation>deve ser uma lista</translation></message>
<message><source>must hold ["state", first cell, cells]</source><translation>deve conter ["state", primeira célula, células]</translation></message>
<message><source>leaves the grid</source><translation>sai da grade</translation></message>
<message><source>names cell %1 twice</source><translation>nomeia duas vezes a célula %1</translation></message>
<message><source>must name a file in the same folder</source><translation>deve nomear um arquivo da mesma pasta</translation></message>
<message><source>save the scan again, or remove "acquisition"</source><translation>salve de novo a varredura, ou remova "acquisition"</translation></message>
<message><source>"acquisition" must be an object {...}</source><translation>"acquisition" deve ser um objeto {...}</translation></message>
<message><source>must be greater than 0</source><translation>deve ser maior que 0</translation></message>
<message><source>the header promises %1 of %2 bytes and the file holds %3 bytes of them, which is more</source><translation>o cabeçalho anuncia %1 de %2 bytes e o arquivo contém %3 bytes deles, o que é mais</translation></message>
<message><source>The last %1 of %2 points hold zeros in all bytes, as a power cut leaves them where a file was not written to its end: they count as no return.</source><translation>Os últimos %1 de %2 pontos contêm zeros em todos os bytes, como os deixa um corte de energia quando um ficheiro não foi escrito até ao fim: contam como sem retorno.</translation></message>
<message><source>holds %1 where the header promises %2</source><translation>contém %1 onde o cabeçalho anuncia %2</translation></message>
<message><source>the header promises %1, and more text follows them here</source><translation>o cabeçalho anuncia %1, e aqui segue mais texto</translation></message>
<message><source>, which repeats exactly and is far apart from the rest, as nothing measured is: taken as no return</source><translation>, que se repete exatamente e está longe do resto, como nada medido está: tomado como sem retorno</translation></message>
<message><source> (--keep-repeated takes it as measured).</source><translation> (--keep-repeated o toma como medido).</translation></message>
<message><source>holds decimal commas in quotes between commas</source><translation>contém vírgulas decimais entre aspas e entre vírgulas</translation></message>
<message><source>save the table with semicolons, or with decimal points</source><translation>salve a tabela com ponto e vírgula, ou com pontos decimais</translation></message>
<message><source>holds decimal commas between commas</source><translation>contém vírgulas decimais entre vírgulas</translation></message>
<message><source>The last row has no line end: the file may have been cut off there; compare it with the original.</source><translation>A última fileira não tem fim de linha: o arquivo pode estar cortado ali; compare-o com o original.</translation></message>
<message><source>save the file with plain numbers, without separators of thousands</source><translation>salve o arquivo com números simples, sem separadores de milhares</translation></message>
<message><source>holds %1 in a column whose numbers have three digits behind their mark or no mark at all, so that it may separate decimals or thousands</source><translation>contém %1 numa coluna cujos números têm três algarismos depois do sinal ou nenhum sinal, de modo que ele pode separar decimais ou milhares</translation></message>
<message><source>save the file with the same count of decimals in each number, or without separators of thousands</source><translation>salve o arquivo com a mesma quantidade de decimais em cada número, ou sem separadores de milhares</translation></message>
<message><source>holds %1, a number whose thousands are set apart</source><translation>contém %1, um número com os milhares separados</translation></message>
<message><source>holds bytes of zero, as a file does that was not written to its end</source><translation>contém bytes zero, como um arquivo que não foi escrito até o fim</translation></message>
<message><source>copy the file or export it again</source><translation>copie ou exporte de novo o arquivo</translation></message>
<message><source>%1 has a decimal comma</source><translation>%1 tem uma vírgula decimal</translation></message>
<message><source>save the file with decimal points</source><translation>salve o arquivo com pontos decimais</translation></message>
<message><source>%1 is more than one number between two separators</source><translation>%1 é mais de um número entre dois separadores</translation></message>
<message><source>correct the line or export the file again</source><translation>corrija a linha ou exporte de novo o arquivo</translation></message>
<message><source>%1 is not a number</source><translation>%1 não é um número</translation></message>
<message><source>%1 is below x, y or z and is not a number</source><translation>%1 está sob x, y ou z e não é um número</translation></message>
<message><source>save the file with plain numbers in these columns, without units or marks</source><translation>salve o arquivo com números simples nestas colunas, sem unidades nem sinais</translation></message>
<message><source>there are words among the numbers of its rows, and no heading names x, y and z</source><translation>há palavras entre os números das suas fileiras, e nenhum cabeçalho nomeia x, y e z</translation></message>
<message><source>write a first row with the names of the columns, such as id,x,y,z,code</source><translation>escreva uma primeira linha com os nomes das colunas, como id,x,y,z,code</translation></message>
<message><source>its numbers are separated by "%1", which separates none here</source><translation>os seus números estão separados por «%1», que aqui não separa nenhum</translation></message>
<message><source>save the file with commas, semicolons, tabs or blanks between its numbers</source><translation>salve o arquivo com vírgulas, pontos e vírgulas, tabulações ou espaços entre os seus números</translation></message>
<message><source>this is text without a row of numbers, so no scan</source><translation>isto é texto sem uma fileira de números, portanto não é uma varredura</translation></message>
<message><source>choose a scan: E57, LAS, PTX, PCD, PLY, OBJ, CSV, XYZ, .3d, .str, .npy, a raw grid (.json), a range picture (.png, .tif), a recording (.mcap), a ROS bag or a network capture (.pcap)</source><translation>escolha uma varredura: E57, LAS, PTX, PCD, PLY, OBJ, CSV, XYZ, .3d, .str, .npy, uma grade bruta (.json), uma imagem de distâncias (.png, .tif), uma gravação (.mcap), um bag de ROS ou uma captura de rede (.pcap)</translation></message>
<message><source>The recording describes another grid than its telegrams make: the telegrams count.</source><translation>A gravação descreve outra grade que a dos seus telegramas: contam os telegramas.</translation></message>
<message><source>The recording was cut off: everything up to the cut is here.</source><translation>A gravação foi cortada: tudo até o corte está aqui.</translation></message>
<message><source>%1 times in the recording are after %2 and were read as this time.</source><translation>%1 tempos da gravação são posteriores a %2 e foram lidos como esse tempo.</translation></message>
<message><source>this MCAP file holds nothing that a laser scanner sent</source><translation>este arquivo MCAP não contém nada enviado por um scanner a laser</translation></message>
<message><source>choose a recording of a sweep</source><translation>escolha a gravação de uma varredura</translation></message>
<message><source>nothing that a laser scanner sent can be read in this MCAP file%1</source><translation>neste arquivo MCAP não se pode ler nada que um scanner a laser tenha enviado%1</translation></message>
<message><source>, and %1 more</source><translation>, e mais %1</translation></message>
<message><source>the recording's "%1" is "%2", which cannot be used.</source><translation>«%1» da gravação é «%2», que não pode ser usado.</translation></message>
<message><source>%n reading of inclinometer or TALIN cannot be used.</source><translation>%n leitura do inclinômetro ou de TALIN não pode ser usada.</translation></message>
<message><source>%n readings of inclinometer or TALIN cannot be used.</source><translation>%n leituras do inclinômetro ou de TALIN não podem ser usadas.</translation></message>
<message><source>the recording's own readings</source><translation>as leituras próprias da gravação</translation></message>
<message><source>The recording holds readings of TALIN and does not say where the boom pointed (boom_azimuth_deg).</source><translation>A gravação contém leituras de TALIN e não diz para onde apontava a lança (boom_azimuth_deg).</translation></message>
<message><source>the recording</source><translation>a gravação</translation></message>
<message><source> with %1</source><translation> com %1</translation></message>
<message><source>a pose needs the robot's calibration, and the recording holds none</source><translation>uma pose precisa da calibração do robô, e a gravação não contém nenhuma</translation></message>
<message><source>give --calibration ROBOT.json too</source><translation>indique também --calibration ROBOT.json</translation></message>
<message><source>a calibration needs a pose, and the recording holds none that can be used</source><translation>uma calibração precisa de uma pose, e a gravação não contém nenhuma utilizável</translation></message>
<message><source>The recording holds poses and not how the robot is built: --calibration ROBOT.json places the scan.</source><translation>A gravação contém poses mas não como o robô é construído: --calibration ROBOT.json posiciona a varredura.</translation></message>
<message><source>The pose in %1 replaces those of the recording.</source><translation>A pose de %1 substitui as da gravação.</translation></message>
<message><source>The recording's pose cannot be used: %1.</source><translation>A pose da gravação não pode ser usada: %1.</translation></message>
<message><source>--unit does not apply: the telegrams of a recording say their unit themselves</source><translation>--unit não se aplica: os telegramas de uma gravação dizem eles mesmos sua unidade</translation></message>
<message><source>one sweep</source><translation>uma varredura</translation></message>
<message><source>%1 sweeps</source><translation>%1 varreduras</translation></message>
<message><source>the %1 scan telegrams in this recording hold no line of ranges</source><translation>os %1 telegramas de varredura desta gravação não contêm linha de distâncias alguma</translation></message>
<message><source>no scan telegram in this recording can be decoded%1</source><translation>nenhum telegrama de varredura desta gravação pode ser decodificado%1</translation></message>
<message><source>this recording holds no scan telegram%1</source><translation>esta gravação não contém telegrama de varredura algum%1</translation></message>
<message><source>choose another recording</source><translation>escolha outra gravação</translation></message>
<message><source>The recording holds %1 sweeps; sweep %2 was opened; no other has more lines.</source><translation>A gravação contém %1 varreduras; foi aberta a varredura %2; nenhuma outra tem mais linhas.</translation></message>
<message><source>%1 scan telegrams could not be decoded: %2.</source><translation>%1 telegramas de varredura não puderam ser decodificados: %2.</translation></message>
<message><source>%n message holds bytes that are not a whole telegram: what was in it is lost.</source><translation>%n mensagem contém bytes que não são um telegrama inteiro: o seu conteúdo está perdido.</translation></message>
<message><source>%n messages hold bytes that are not a whole telegram: what was in them is lost.</source><translation>%n mensagens contêm bytes que não são um telegrama inteiro: o seu conteúdo está perdido.</translation></message>
<message><source>INCOMPLETE: %1 lines are there, how many there were is not known.</source><translation>INCOMPLETO: há %1 linhas, não se sabe quantas eram.</translation></message>
<message><source>a recording holds whole counts of its unit up to 65535, and the range at line %1, beam %2 is none</source><translation>uma gravação contém contagens inteiras de sua unidade até 65535, e a distância na linha %1, feixe %2 não é uma</translation></message>
<message><source>a recording needs beam and line angles and this cloud has none</source><translation>uma gravação precisa de ângulos de feixes e de linhas e esta nuvem não os tem</translation></message>
<message><source>a recording holds at most %1 lines of %2 beams</source><translation>uma gravação contém no máximo %1 linhas de %2 feixes</translation></message>
<message><source>telegrams cannot describe this scan</source><translation>telegramas não podem descrever esta varredura</translation></message>
<message><source>the disk is %1 s behind (%2 MB)</source><translation>o disco está %1 s atrasado (%2 MB)</translation></message>
<message><source>the disk is slower than the scanner, telegrams are missing in the recording</source><translation>o disco é mais lento que o scanner, faltam telegramas na gravação</translation></message>
<message><source>record on another disk</source><translation>grave em outro disco</translation></message>
<message><source>the disk did not take the end of the recording, what it has is cut off</source><translation>o disco não aceitou o fim da gravação, o que ele tem está cortado</translation></message>
<message><source>check the disk; the file opens with what was written</source><translation>verifique o disco; o arquivo abre com o que foi escrito</translation></message>
<message><source>The bag is cut off or damaged at byte %1: the last %2.</source><translation>O bag está cortado ou danificado no byte %1: os últimos %2.</translation></message>
<message><source>%n byte was not read</source><translation>%n byte não foi lido</translation></message>
<message><source>%n bytes were not read</source><translation>%n bytes não foram lidos</translation></message>
<message><source>%n chunk is damaged and was left out (%1).</source><translation>%n bloco está danificado e foi deixado de fora (%1).</translation></message>
<message><source>%n chunks are damaged and were left out (%1).</source><translation>%n blocos estão danificados e foram deixados de fora (%1).</translation></message>
<message><source>%n message belongs to no topic of the bag and was left out.</source><translation>%n mensagem não pertence a nenhum tópico do bag e foi deixada de fora.</translation></message>
<message><source>%n messages belong to no topic of the bag and were left out.</source><translation>%n mensagens não pertencem a nenhum tópico do bag e foram deixadas de fora.</translation></message>
<message><source>its records do not end with it</source><translation>seus registros não terminam com ele</translation></message>
<message><source>it is a ROS bag of another version than 2.0</source><translation>é um bag do ROS de versão diferente de 2.0</translation></message>
<message><source>convert it with "rosbag migrate"</source><translation>converta-o com "rosbag migrate"</translation></message>
<message><source>it promises to unpack to more than a bag of this size holds</source><translation>anuncia que se descompacta em mais do que um bag deste tamanho contém</translation></message>
<message><source>The bag was cut off: everything up to the cut is here.</source><translation>O bag foi cortado: tudo até o corte está aqui.</translation></message>
<message><source>%n message is compressed and damaged and was left out.</source><translation>%n mensagem está comprimida e danificada e foi deixada de fora.</translation></message>
<message><source>%n messages are compressed and damaged and were left out.</source><translation>%n mensagens estão comprimidas e danificadas e foram deixadas de fora.</translation></message>
<message><source>this SQLite database is damaged: its tables give more than the file can hold</source><translation>este banco de dados SQLite está danificado: suas tabelas dão mais do que o arquivo pode conter</translation></message>
<message><source>this SQLite database is not a ROS bag: "%1" is not a plain table</source><translation>este banco de dados SQLite não é um bag de ROS: «%1» não é uma tabela simples</translation></message>
<message><source>this SQLite database is cut off or damaged: its tables cannot be read</source><translation>esta base SQLite está cortada ou danificada: não é possível ler suas tabelas</translation></message>
<message><source>this SQLite database is not a ROS bag: it has no table of topics</source><translation>esta base SQLite não é um bag do ROS: não tem tabela de tópicos</translation></message>
<message><source>The database is cut off or damaged (%1): messages behind the first %2 were not read.</source><translation>O banco de dados está cortado ou danificado (%1): as mensagens depois das primeiras %2 não foram lidas.</translation></message>
<message><source>this SQLite database cannot be opened</source><translation>não é possível abrir esta base SQLite</translation></message>
<message><source>%n byte behind the end of the database was not read.</source><translation>%n byte depois do fim do banco de dados não foi lido.</translation></message>
<message><source>%n bytes behind the end of the database were not read.</source><translation>%n bytes depois do fim do banco de dados não foram lidos.</translation></message>
<message><source>this is a ROS 2 bag in SQLite, and this program was built without SQLite</source><translation>isto é um bag de ROS 2 em SQLite, e este programa foi compilado sem SQLite</translation></message>
<message><source>convert it with "ros2 bag convert" to MCAP, or install libsqlite3-dev and build again</source><translation>converta-o com "ros2 bag convert" para MCAP, ou instale libsqlite3-dev e compile de novo</translation></message>
<message><source>The log %1 of the recorder could not be read: its messages are not in the scan.</source><translation>O registro %1 do gravador não pôde ser lido: as suas mensagens não estão na varredura.</translation></message>
<message><source>The recorder was not ended: its newest messages were read from %1.</source><translation>O gravador não foi encerrado: suas mensagens mais novas foram lidas de %1.</translation></message>
<message><source>The recorder was ended within a change: the database was read as it was before it, by %1.</source><translation>O gravador terminou no meio de uma alteração: o banco de dados foi lido como estava antes, por meio de %1.</translation></message>
<message><source>The log %1 of the recorder ends with %2 pages that are not whole: their messages are not in the scan.</source><translation>O registro %1 do gravador termina com %2 páginas incompletas: as suas mensagens não estão na varredura.</translation></message>
<message><source>The log %1 belongs to several databases and was not read: the last change may be in part.</source><translation>O registro %1 pertence a vários bancos de dados e não foi lido: a última alteração pode estar pela metade.</translation></message>
<message><source>the log %1 cannot be read: the folder for temporary files is missing</source><translation>o registro %1 não pode ser lido: falta a pasta de arquivos temporários</translation></message>
<message><source>set TMPDIR to a folder</source><translation>ponha uma pasta em TMPDIR</translation></message>
<message><source>it is longer than a megabyte</source><translation>é mais longa que um megabyte</translation></message>
<message><source>a line of "=" is not followed by "MSG:"</source><translation>a uma linha de "=" não se segue "MSG:"</translation></message>
<message><source>it names more than 1000 types</source><translation>nomeia mais de 1000 tipos</translation></message>
<message><source>the type %1 is not defined</source><translation>o tipo %1 não está definido</translation></message>
<message><source>a type contains itself, or types are nested more than 32 deep</source><translation>um tipo contém a si mesmo, ou há tipos aninhados em mais de 32 níveis</translation></message>
<message><source>the definition of the message type %1 cannot be read: %2</source><translation>a definição do tipo de mensagem %1 não pode ser lida: %2</translation></message>
<message><source>record the bag again, or convert it with the program that wrote it</source><translation>grave de novo o bag, ou converta-o com o programa que o escreveu</translation></message>
<message><source>a line has a type and no name: "%1"</source><translation>uma linha tem um tipo e não um nome: "%1"</translation></message>
<message><source>a field has no name: "%1"</source><translation>um campo não tem nome: "%1"</translation></message>
<message><source>the length of "%1" is not a number</source><translation>o comprimento de «%1» não é um número</translation></message>
<message><source>a message of type %1 is encoded in a way that is not read (PLAIN_CDR and PLAIN_CDR2 are)</source><translation>uma mensagem do tipo %1 está codificada de um modo que não é lido (PLAIN_CDR e PLAIN_CDR2 são)</translation></message>
<message><source>record it with another middleware, or convert the bag</source><translation>grave-o com outro middleware, ou converta o bag</translation></message>
<message><source>a message of type %1 ends too early or does not fit its definition</source><translation>uma mensagem do tipo %1 termina cedo demais ou não corresponde à sua definição</translation></message>
<message><source>copy the bag again</source><translation>copie de novo o bag</translation></message>
<message><source>the bridge closed the connection</source><translation>a ponte fechou a conexão</translation></message>
<message><source>the bridge sends a message of more than 64 MB</source><translation>a ponte envia uma mensagem de mais de 64 MB</translation></message>
<message><source>choose another topic</source><translation>escolha outro tópico</translation></message>
<message><source>the connection broke (%1)</source><translation>a conexão foi interrompida (%1)</translation></message>
<message><source>check power, cable and the address, and that this computer is in the robot's network</source><translation>verifique a alimentação, o cabo e o endereço, e que este computador está na rede do robô</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs on the robot</source><translation>verifique a porta (8765) e que foxglove_bridge roda no robô</translation></message>
<message><source>what answers there is not a Foxglove bridge</source><translation>o que responde ali não é uma ponte Foxglove</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs there; a scanner of SICK is HOST without ws://</source><translation>verifique a porta (8765) e que foxglove_bridge roda ali; um scanner da SICK é HOST sem ws://</translation></message>
<message><source>the connection is closed</source><translation>a conexão está fechada</translation></message>
<message><source>the subscription cannot be sent (%1)</source><translation>a assinatura não pode ser enviada (%1)</translation></message>
<message><source>check the network</source><translation>verifique a rede</translation></message>
<message><source>%1 accepts the connection; asking for its topics.</source><translation>%1 aceita a conexão; perguntando por seus tópicos.</translation></message>
<message><source>the bridge says: %1</source><translation>a ponte diz: %1</translation></message>
<message><source>check foxglove_bridge on the robot</source><translation>verifique foxglove_bridge no robô</translation></message>
<message><source>the bridge offers no topics</source><translation>a ponte não oferece tópico algum</translation></message>
<message><source>check that the robot's programs run</source><translation>verifique que os programas do robô estão rodando</translation></message>
<message><source>no scan line of %1 for %2</source><translation>nenhuma linha de varredura de %1 em %2</translation></message>
<message><source>check whether the laser runs and publishes this topic</source><translation>verifique se o laser funciona e publica este tópico</translation></message>
<message><source>the bridge describes its topics in a text of more than 4 MB</source><translation>a ponte descreve seus tópicos num texto de mais de 4 MB</translation></message>
<message><source>choose another bridge, or let it offer fewer topics</source><translation>escolha outra ponte, ou faça-a oferecer menos tópicos</translation></message>
<message><source>what it sends is not the Foxglove WebSocket protocol</source><translation>o que ela envia não é o protocolo WebSocket do Foxglove</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs there</source><translation>verifique a porta (8765) e que foxglove_bridge roda ali</translation></message>
<message><source>%1 and others</source><translation>%1 e outros</translation></message>
<message><source>lines come, but their angle is not known: %1</source><translation>chegam linhas, mas seu ângulo não é conhecido: %1</translation></message>
<message><source>give the joint that turns the laser (--joint), or the step from line to line (--line-step)</source><translation>indique a junta que gira o laser (--joint), ou o passo de linha a linha (--line-step)</translation></message>
<message><source>there is not enough memory for this cloud</source><translation>não há memória suficiente para esta nuvem</translation></message>
<message><source>the bridge offers no topic of a laser (sensor_msgs/LaserScan or PointCloud2)%1</source><translation>a ponte não oferece tópico de um laser (sensor_msgs/LaserScan ou PointCloud2)%1</translation></message>
<message><source>check that the laser's driver runs</source><translation>verifique que o driver do laser está rodando</translation></message>
<message><source>the bridge offers no topic of a laser called "%1"</source><translation>a ponte não oferece tópico de um laser chamado «%1»</translation></message>
<message><source>choose one of %1</source><translation>escolha um de %1</translation></message>
<message><source>GUESS: the topic %1 was taken; --topic chooses another: %2.</source><translation>SUPOSIÇÃO: foi tomado o tópico %1; --topic escolhe outro: %2.</translation></message>
<message><source>%1 messages of the topic %2 are in the bag twice: each was read once.</source><translation>%1 mensagens do tópico %2 estão duas vezes no bag: cada uma foi lida uma vez.</translation></message>
<message><source>it is not a file of a bag</source><translation>não é um arquivo de um bag</translation></message>
<message><source>The part %1 of the bag could not be read (%2): its messages are not in the scan.</source><translation>A parte %1 do bag não pôde ser lida (%2): as suas mensagens não estão na varredura.</translation></message>
<message><source>The part %1 of the bag is missing: its messages are not in the scan.</source><translation>Falta a parte %1 do bag: as suas mensagens não estão na varredura.</translation></message>
<message><source>metadata.yaml does not name %1, a part of the bag by its name: its messages are not in the scan.</source><translation>metadata.yaml não nomeia %1, que pelo seu nome é uma parte do bag: as suas mensagens não estão no scan.</translation></message>
<message><source>metadata.yaml names %1, whose name is not that of a file of messages (.mcap, .db3, .bag): it was not read.</source><translation>metadata.yaml nomeia %1, cujo nome não é o de um arquivo de mensagens (.mcap, .db3, .bag): não foi lido.</translation></message>
<message><source>no part of the bag is there</source><translation>nenhuma parte do bag está ali</translation></message>
<message><source>this is not the metadata of an Ouster: beam angles or columns of a frame are missing</source><translation>estes não são os metadados de um Ouster: faltam os ângulos dos feixes ou as colunas de um quadro</translation></message>
<message><source>save the sensor's metadata again</source><translation>salve de novo os metadados do sensor</translation></message>
<message><source>the capture</source><translation>a captura</translation></message>
<message><source>%1 turns</source><translation>%1 voltas</translation></message>
<message><source>The capture holds %1 turns of the scanner; turn %2, counted from 0, was opened. --scan chooses another.</source><translation>A captura contém %1 voltas do scanner; foi aberta a volta %2, contada a partir de 0. --scan escolhe outra.</translation></message>
<message><source>%n packet came out of order and was put in the order of the scanner's clock.</source><translation>%n pacote chegou fora de ordem e foi posto na ordem do relógio do scanner.</translation></message>
<message><source>%n packets came out of order and were put in the order of the scanner's clock.</source><translation>%n pacotes chegaram fora de ordem e foram postos na ordem do relógio do scanner.</translation></message>
<message><source>%n packet is missing in part in the capture: its lines are lost.</source><translation>%n pacote falta em parte na captura: as suas linhas estão perdidas.</translation></message>
<message><source>%n packets are missing in part in the capture: their lines are lost.</source><translation>%n pacotes faltam em parte na captura: as suas linhas estão perdidas.</translation></message>
<message><source>%n packet is in the capture twice: it was read once.</source><translation>%n pacote está duas vezes na captura: foi lido uma vez.</translation></message>
<message><source>%n packets are in the capture twice: each was read once.</source><translation>%n pacotes estão duas vezes na captura: cada um foi lido uma vez.</translation></message>
<message><source>The capture holds packets of %1 scanners; the one with most of them was opened.</source><translation>A captura contém pacotes de %1 scanners; foi aberto o que tem mais.</translation></message>
<message><source>The scanner sent two returns for each beam: the strongest ones are here, and %1 left out.</source><translation>O scanner enviou dois retornos por feixe: aqui estão os mais fortes, e ficaram de fora %1.</translation></message>
<message><source>%n other of the capture was</source><translation>%n outro da captura</translation></message>
<message><source>%n others of the capture were</source><translation>%n outros da captura</translation></message>
<message><source>The beams of a VLP-16 begin up to 11 mm above and below its middle: points are that far off.</source><translation>Os feixes de um VLP-16 começam até 11 mm acima e abaixo do seu meio: os pontos estão desviados outro tanto.</translation></message>
<message><source>the packets of an Ouster do not say the angles of its beams</source><translation>os pacotes de um Ouster não dizem os ângulos de seus feixes</translation></message>
<message><source>save the sensor's metadata as %1 next to the capture</source><translation>salve os metadados do sensor como %1 junto da captura</translation></message>
<message><source>no packet of the capture fits the sensor of %1</source><translation>nenhum pacote da captura corresponde ao sensor de %1</translation></message>
<message><source>save the metadata of the sensor that was captured</source><translation>salve os metadados do sensor que foi capturado</translation></message>
<message><source>The beams of an Ouster begin some centimetres away from its axis, and the ranges are as measured: points are that far off.</source><translation>Os feixes de um Ouster começam a alguns centímetros do seu eixo, e as distâncias são as medidas: os pontos estão desviados outro tanto.</translation></message>
<message><source>%n line of the turn is missing in the capture and is shown as lost.</source><translation>%n linha da volta falta na captura e é mostrada como perdida.</translation></message>
<message><source>%n lines of the turn are missing in the capture and are shown as lost.</source><translation>%n linhas da volta faltam na captura e são mostradas como perdidas.</translation></message>
<message><source>the capturing computer's clock, carried on by the scanner's</source><translation>o relógio do computador que capturou, continuado pelo do scanner</translation></message>
<message><source>The cloud is of a scanner with several beams: its rings are the beams, and its firings the lines.</source><translation>A nuvem é de um scanner de vários feixes: os seus anéis são os feixes, e os seus disparos as linhas.</translation></message>
<message><source>the cloud has no fields x, y and z</source><translation>a nuvem não tem campos x, y e z</translation></message>
<message><source>the cloud promises %1 x %2 points of %3 bytes and holds %4 bytes</source><translation>a nuvem anuncia %1 x %2 pontos de %3 bytes e contém %4 bytes</translation></message>
<message><source>choose another topic or message</source><translation>escolha outro tópico ou outra mensagem</translation></message>
<message><source>the topic %1</source><translation>o tópico %1</translation></message>
<message><source>one cloud</source><translation>uma nuvem</translation></message>
<message><source>%1 clouds</source><translation>%1 nuvens</translation></message>
<message><source>The bag holds no definition of its messages: that of the ROS 2 release of 2022 was ASSUMED.</source><translation>O bag não contém a definição das suas mensagens: foi SUPOSTA a do ROS 2 de 2022.</translation></message>
<message><source>The topic %1 holds a cloud in each message; message %2, counted from 0, was opened. --scan chooses another.</source><translation>O tópico %1 contém uma nuvem em cada mensagem; foi aberta a mensagem %2, contada a partir de 0. --scan escolhe outra.</translation></message>
<message><source>no file of messages that metadata.yaml names is in this folder: %1%2</source><translation>nenhum arquivo de mensagens que metadata.yaml nomeia está nesta pasta: %1%2</translation></message>
<message><source> and %1 more</source><translation> e mais %1</translation></message>
<message><source>copy the files of the bag into it</source><translation>copie para ela os arquivos do bag</translation></message>
<message><source>this folder holds %1 of several bags</source><translation>esta pasta contém %1 de vários bags</translation></message>
<message><source>%n file</source><translation>%n arquivo</translation></message>
<message><source>%n files</source><translation>%n arquivos</translation></message>
<message><source>open one of them, as %1</source><translation>abra um deles, como %1</translation></message>
<message><source>This file is part %1 of %2 of a bag. Open %3 for all of it.</source><translation>Este arquivo é a parte %1 de %2 de um bag. Abra %3 para tê-lo inteiro.</translation></message>
<message><source>%n message of the topic was left out: %1.</source><translation>%n mensagem do tópico foi deixada de fora: %1.</translation></message>
<message><source>%n messages of the topic were left out: %1.</source><translation>%n mensagens do tópico foram deixadas de fora: %1.</translation></message>
<message><source>%n message has a time_increment that cannot be: the beams of a line count as measured at once.</source><translation>%n mensagem tem um time_increment impossível: os feixes de uma linha contam como medidos ao mesmo tempo.</translation></message>
<message><source>%n messages have a time_increment that cannot be: the beams of a line count as measured at once.</source><translation>%n mensagens têm um time_increment impossível: os feixes de uma linha contam como medidos ao mesmo tempo.</translation></message>
<message><source>%n line came out of order and was put in the order of its stamp</source><translation>%n linha chegou fora de ordem e foi posta na ordem da sua hora</translation></message>
<message><source>%n lines came out of order and were put in the order of their stamps</source><translation>%n linhas chegaram fora de ordem e foram postas na ordem das suas horas</translation></message>
<message><source>%n message of the topic is in the bag twice, with the same stamp and ranges: it was read once.</source><translation>%n mensagem do tópico está duas vezes no bag, com a mesma hora e as mesmas distâncias: foi lida uma vez.</translation></message>
<message><source>%n messages of the topic are in the bag twice, with the same stamp and ranges: each was read once.</source><translation>%n mensagens do tópico estão duas vezes no bag, com a mesma hora e as mesmas distâncias: cada uma foi lida uma vez.</translation></message>
<message><source>In %1 angle_max is not where angle_min and angle_increment put the last beam: angle_increment was used, and the beams may be mirrored or turned.</source><translation>Em %1 angle_max não está onde angle_min e angle_increment põem o último feixe: foi usado angle_increment, e os feixes podem estar espelhados ou girados.</translation></message>
<message><source>%n message of joints is damaged and was left out.</source><translation>%n mensagem de juntas está danificada e foi deixada de fora.</translation></message>
<message><source>%n messages of joints are damaged and were left out.</source><translation>%n mensagens de juntas estão danificadas e foram deixadas de fora.</translation></message>
<message><source>GUESS: the angle of each line comes from %1.</source><translation>SUPOSIÇÃO: o ângulo de cada linha tem como origem %1.</translation></message>
<message><source>A joint does not say how the laser is mounted on it. ASSUMED: the axis (%1). Give --axis where that is wrong.</source><translation>Uma junta não diz como o laser está montado nela. SUPOSTO: o eixo (%1). Indique --axis onde isso estiver errado.</translation></message>
<message><source>sweep, by the name of the joint</source><translation>sweep, pelo nome da junta</translation></message>
<message><source>The axis is %1 degrees out of the plane of the fan: points are that far off.</source><translation>O eixo está %1 graus fora do plano do leque: os pontos estão desviados outro tanto.</translation></message>
<message><source>The laser is %1 mm off its axis: ranges are as measured, and points are as if it were on the axis.</source><translation>O laser está a %1 mm do seu eixo: as distâncias são as medidas, e os pontos como se estivesse no eixo.</translation></message>
<message><source>%n line was measured before the first or after the last angle and was left out.</source><translation>%n linha foi medida antes do primeiro ângulo ou depois do último e foi deixada de fora.</translation></message>
<message><source>%n lines were measured before the first or after the last angle and were left out.</source><translation>%n linhas foram medidas antes do primeiro ângulo ou depois do último e foram deixadas de fora.</translation></message>
<message><source>%n line was measured while the laser did not turn and was left out.</source><translation>%n linha foi medida enquanto o laser não girava e foi deixada de fora.</translation></message>
<message><source>%n lines were measured while the laser did not turn and were left out.</source><translation>%n linhas foram medidas enquanto o laser não girava e foram deixadas de fora.</translation></message>
<message><source>the laser did not turn while it measured</source><translation>o laser não girou enquanto media</translation></message>
<message><source>choose another topic, or give the joint that turns it</source><translation>escolha outro tópico ou indique a junta que o gira</translation></message>
<message><source>assembling lines</source><translation>montando linhas</translation></message>
<message><source>no line of the topic %1 could be placed</source><translation>não foi possível posicionar nenhuma linha do tópico %1</translation></message>
<message><source>The topic holds %1 sweeps; sweep %2, counted from 0, was opened. --scan chooses another.</source><translation>O tópico contém %1 varreduras; foi aberta a varredura %2, contada a partir de 0. --scan escolhe outra.</translation></message>
<message><source>the stamps of the messages</source><translation>as marcas de tempo das mensagens</translation></message>
<message><source>%1 x %2 points with %3</source><translation>%1 x %2 pontos com %3</translation></message>
<message><source>%1turn rates and accelerations, which are not used: transforms and joints turn the laser</source><translation>%1velocidades de giro e acelerações, que não são usadas: as transformações e as juntas giram o laser</translation></message>
<message><source>scan lines of %1 beams</source><translation>linhas de varredura de %1 feixes</translation></message>
<message><source>poses in the frame %1</source><translation>poses no referencial %1</translation></message>
<message><source> at %1 Hz</source><translation> a %1 Hz</translation></message>
<message><source>no topic of this %1 is a laser's%2%3</source><translation>nenhum tópico deste %1 é de um laser%2%3</translation></message>
<message><source>choose another bag</source><translation>escolha outro bag</translation></message>
<message><source>the bag has no topic "%1"</source><translation>o bag não tem tópico «%1»</translation></message>
<message><source>the topic %1 holds no scan</source><translation>o tópico %1 não contém nenhuma varredura</translation></message>
<message><source> messages of transforms are damaged and were left out.</source><translation> mensagens de transformações estão danificadas e foram deixadas de fora.</translation></message>
<message><source> transforms of the bag have no rotation, no name or no finite numbers and were left out.</source><translation> transformações do bag não têm rotação, nome ou números finitos e foram deixadas de fora.</translation></message>
<message><source> transforms name another parent for their frame than the first one and were left out.</source><translation> transformações nomeiam outro pai do seu referencial que a primeira e foram deixadas de fora.</translation></message>
<message><source> transforms of the bag are of more frames than any robot has and were left out.</source><translation> transformações do bag são de mais referenciais do que um robô tem e foram deixadas de fora.</translation></message>
<message><source>The transforms of the bag form a loop at the frame %1.</source><translation>As transformações do bag formam um laço no referencial %1.</translation></message>
<message><source>The transforms of the bag form a chain of more than %1 frames: those above are not used.</source><translation>As transformações do bag formam uma cadeia de mais de %1 referenciais: os de cima não são usados.</translation></message>
<message><source>ranges of the topic are %1 m, the range_min of their messages</source><translation>distâncias do tópico são %1 m, o range_min das suas mensagens</translation></message>
<message><source>ranges of the topic are %1 m</source><translation>distâncias do tópico são %1 m</translation></message>
<message><source>it has no beams or no stamp</source><translation>não tem feixes ou não tem marca de tempo</translation></message>
<message><source>its angle_increment does not give the step between beams</source><translation>seu angle_increment não dá o passo entre feixes</translation></message>
<message><source>its angle_min or angle_increment puts beams outside of one turn</source><translation>seu angle_min ou angle_increment põe feixes fora de uma volta</translation></message>
<message><source>no message of the topic %1 is a line of ranges%2</source><translation>nenhuma mensagem do tópico %1 é uma linha de distâncias%2</translation></message>
<message><source>GUESS: the poses of the topic %1 are those of the frame %2.</source><translation>SUPOSIÇÃO: as poses do tópico %1 são as do referencial %2.</translation></message>
<message><source>The transforms put the scanner at %1, %2, %3 m, where nothing on earth is: the scan stays in the scanner's frame.</source><translation>As transformações põem o scanner em %1, %2, %3 m, onde não há nada na terra: a varredura fica no referencial do scanner.</translation></message>
<message><source>the frame %1 of the bag</source><translation>o referencial %1 do bag</translation></message>
<message><source>the transforms of the bag</source><translation>as transformações do bag</translation></message>
<message><source>GUESS: the frame %1 of the bag is taken as the mine grid, with x to the east, y to the north and z up.</source><translation>SUPOSIÇÃO: o referencial %1 do bag é tomado como grade da mina, com x para leste, y para norte e z para cima.</translation></message>
<message><source>the transform of the frame %1 in %2</source><translation>a transformação do referencial %1 em %2</translation></message>
<message><source>%1 turns about more than one axis (%2 degrees off)</source><translation>%1 gira em torno de mais de um eixo (diferença de %2 graus)</translation></message>
<message><source>choose another topic, or give the joint that turns the laser</source><translation>escolha outro tópico, ou indique a junta que gira o laser</translation></message>
<message><source>%1 turns the laser in the plane of its own fan: that is not a sweep</source><translation>%1 gira o laser no plano de seu próprio leque: isso não é uma varredura</translation></message>
<message><source>no transform turns the laser's frame %1 while it measures</source><translation>nenhuma transformação gira o referencial %1 do laser enquanto mede</translation></message>
<message><source>give the joint that turns it (--joint), or the step from line to line (--line-step) and the axis (--axis)</source><translation>indique a junta que o gira (--joint), ou o passo de linha a linha (--line-step) e o eixo (--axis)</translation></message>
<message><source>no joint turned while the laser measured</source><translation>nenhuma junta girou enquanto o laser media</translation></message>
<message><source>there is no joint called %1</source><translation>não há junta chamada %1</translation></message>
<message><source>give the step from line to line (--line-step), or choose another topic</source><translation>indique o passo de linha a linha (--line-step), ou escolha outro tópico</translation></message>
<message><source>the joint %1</source><translation>a junta %1</translation></message>
<message><source>there are too many topics</source><translation>há tópicos demais</translation></message>
<message><source>a line came out of order</source><translation>uma linha chegou fora de ordem</translation></message>
<message><source>the angle of a line is not known</source><translation>o ângulo de uma linha não é conhecido</translation></message>
<message><source>the laser did not turn yet</source><translation>o laser ainda não girou</translation></message>
<message><source>%1 degrees</source><translation>%1 graus</translation></message>
<message><source>, %1 times its uncertainty</source><translation>, %1 vezes sua incerteza</translation></message>
<message><source>odd beams lie %1 ahead of even ones%2</source><translation>os feixes ímpares estão %1 à frente dos pares%2</translation></message>
<message><source>odd beams lie %1 behind even ones%2</source><translation>os feixes ímpares estão %1 atrás dos pares%2</translation></message>
<message><source>, %1 times the usual unevenness of its steps</source><translation>, %1 vezes a irregularidade habitual de seus passos</translation></message>
<message><source>the stepper slipped at %1 (first at line %2, by up to %3%4)</source><translation>o motor de passo escorregou em %1 (primeiro na linha %2, até %3%4)</translation></message>
<message><source>%n line</source><translation>%n linha</translation></message>
<message><source>%n lines</source><translation>%n linhas</translation></message>
<message><source>the beams of %1 lines in turn lie %2 and %3 degrees ahead of where they should be%4</source><translation>os feixes de %1 linhas estão por vez %2 e %3 graus à frente de onde deveriam%4</translation></message>
<message><source> At %1 of the first and last lines the stepper still swung back: folds there are left out.</source><translation> Em %1 das primeiras e últimas linhas o motor de passo ainda oscilava: as dobras ali são deixadas de fora.</translation></message>
<message><source>Not measured at the angles that the file gives: </source><translation>Não medido nos ângulos que o arquivo dá: </translation></message>
<message><source>Not straightened: the scan has no lines with angles.</source><translation>Não endireitado: a varredura não tem linhas com ângulos.</translation></message>
<message><source>Straightened: %1, and were put side by side: %2 lines make one.</source><translation>Endireitado: %1, e foram postas lado a lado: %2 linhas formam uma.</translation></message>
<message><source>Straightened: no interlaced beams and no slips were found; the angles stay.</source><translation>Endireitado: não se acharam feixes entrelaçados nem escorregamentos; os ângulos ficam.</translation></message>
<message><source>%n slip was seen in every second beam only, and is left as it is.</source><translation>%n escorregamento foi visto só num feixe em cada dois e fica como está.</translation></message>
<message><source>%n slips were seen in every second beam only, and are left as they are.</source><translation>%n escorregamentos foram vistos só num feixe em cada dois e ficam como estão.</translation></message>
<message><source>; edges across the lines are combed: --straighten (Scan &gt; Straighten Beams) puts these lines side by side as one.</source><translation>; as arestas que cruzam as linhas ficam dentadas: --straighten (Scan &gt; Straighten Beams) põe estas linhas lado a lado como uma.</translation></message>
<message><source>; EdgeScan+ allows for it, but the cloud does not: --straighten (Scan &gt; Straighten Beams) corrects the angles.</source><translation>; EdgeScan+ leva isso em conta, mas a nuvem não: --straighten (Scan &gt; Straighten Beams) corrige os ângulos.</translation></message>
<message><source>has no direction</source><translation>não tem direção</translation></message>
<message><source>and "head_in_robot_m" exclude each other</source><translation>e "head_in_robot_m" se excluem</translation></message>
<message><source>compare it with the example in docs/reference/coordinates.md</source><translation>compare-o com o exemplo de docs/reference/coordinates.md</translation></message>
<message><source>the inclinometer's two axes cannot be raised by %1 and %2 degrees at once</source><translation>os dois eixos do inclinômetro não podem se levantar %1 e %2 graus ao mesmo tempo</translation></message>
<message><source>check whether it reads pitch and roll instead of the elevations of its axes</source><translation>verifique se ele lê arfagem e rolagem em vez das elevações de seus eixos</translation></message>
<message><source>a boom slewed by %1 degrees on this robot cannot be raised by %2</source><translation>uma lança girada %1 graus neste robô não pode se levantar %2</translation></message>
<message><source>check the slew angle and the inclinometer</source><translation>verifique o ângulo de giro e o inclinômetro</translation></message>
<message><source>RL, positive up [m]</source><translation>RL, positivo para cima [m]</translation></message>
<message><source>Heading, clockwise from north [degrees]</source><translation>Rumo, do norte em sentido horário [graus]</translation></message>
<message><source>North of the heading</source><translation>Norte do rumo</translation></message>
<message><source>Tilt: pitch, nose up [degrees]</source><translation>Inclinação: arfagem, nariz para cima [graus]</translation></message>
<message><source>Tilt: roll, right side down [degrees]</source><translation>Inclinação: rolagem, lado direito para baixo [graus]</translation></message>
<message><source>Zone or EPSG code</source><translation>Zona ou código EPSG</translation></message>
<message><source>Azimuth of the boom, positive to the left [degrees]</source><translation>Azimute da lança, positivo para a esquerda [graus]</translation></message>
<message><source>Robot's pitch, nose up [degrees]</source><translation>Arfagem do robô, nariz para cima [graus]</translation></message>
<message><source>Robot's roll, right side down [degrees]</source><translation>Rolagem do robô, lado direito para baixo [graus]</translation></message>
<message><source>Name of robot or scanner</source><translation>Nome do robô ou do scanner</translation></message>
<message><source>Boresight: roll, pitch, yaw [degrees]</source><translation>Alinhamento: rolagem, arfagem, guinada [graus]</translation></message>
<message><source>Lever arm of TALIN in the robot: forward, left, up [m]</source><translation>Braço de alavanca do TALIN no robô: frente, esquerda, cima [m]</translation></message>
<message><source>Lever arm of the head in the robot: forward, left, up [m]</source><translation>Braço de alavanca da cabeça no robô: frente, esquerda, cima [m]</translation></message>
<message><source>Pivot of a boom in the robot, in place of the head [m]</source><translation>Pivô de uma lança no robô, em lugar da cabeça [m]</translation></message>
<message><source>From pivot to head [m]</source><translation>Do pivô à cabeça [m]</translation></message>
<message><source>The boom's azimuth turns about</source><translation>O azimute da lança gira em torno de</translation></message>
<message><source>The scanner looks</source><translation>O scanner olha</translation></message>
<message><source>Looking direction: roll, pitch, yaw [degrees]</source><translation>Direção do olhar: rolagem, arfagem, guinada [graus]</translation></message>
<message><source>Looking direction: nine numbers by rows</source><translation>Direção do olhar: nove números por linhas</translation></message>
<message><source>Axis of the stepper from the inclinometer [m]</source><translation>Eixo do motor a partir do inclinômetro [m]</translation></message>
<message><source>Tilt is given as</source><translation>A inclinação é dada como</translation></message>
<message><source>Scanner on the stepper: roll, pitch, yaw [degrees]</source><translation>Scanner sobre o motor: rolagem, arfagem, guinada [graus]</translation></message>
<message><source>Scanner on the stepper: x, y, z [m]</source><translation>Scanner sobre o motor: x, y, z [m]</translation></message>
<message><source>Axis of the stepper</source><translation>Eixo do motor</translation></message>
<message><source>Zero of the stepper [degrees]</source><translation>Zero do motor [graus]</translation></message>
<message><source>Direction of the stepper, 1 or -1</source><translation>Sentido do motor, 1 ou -1</translation></message>
<message><source>Step from line to line [degrees]</source><translation>Passo de linha a linha [graus]</translation></message>
<message><source>Beam at the time stamp of a line [degrees]</source><translation>Feixe no instante de uma linha [graus]</translation></message>
<message><source>Grid convergence [degrees]</source><translation>Convergência da grade [graus]</translation></message>
<message><source>Scale of the grid</source><translation>Escala da grade</translation></message>
<message><source>Largest change of tilt during a sweep [degrees]</source><translation>Maior mudança de inclinação durante uma passagem [graus]</translation></message>
<message><source>Largest age of a pose [s]</source><translation>Maior idade de uma pose [s]</translation></message>
<message><source>%1 is missing.</source><translation>%1 falta.</translation></message>
<message><source>%1: "%2" is not a number.</source><translation>%1: «%2» não é um número.</translation></message>
<message><source>%1: "%2" is not three numbers.</source><translation>%1: «%2» não são três números.</translation></message>
<message><source>%1: "%2" is not nine numbers.</source><translation>%1: «%2» não são nove números.</translation></message>
<message><source>the file must hold an object {...}</source><translation>o arquivo deve conter um objeto {...}</translation></message>
<message><source>choose a pose or calibration file</source><translation>escolha um arquivo de pose ou de calibração</translation></message>
<message><source>the pose is of robot "%1" and the calibration of "%2"</source><translation>a pose é do robô «%1» e a calibração de «%2»</translation></message>
<message><source>give the calibration of the robot that made the scan</source><translation>indique a calibração do robô que fez a varredura</translation></message>
<message><source>the scan turns about %1 and the stepper of the calibration about another axis, %2 degrees away</source><translation>a varredura gira em torno de %1 e o motor de passo da calibração em torno de outro eixo, a %2 graus</translation></message>
<message><source>x (sweep)</source><translation>x (sweep)</translation></message>
<message><source>z (spin)</source><translation>z (spin)</translation></message>
<message><source>open the scan with the right --axis, or correct "stepper.axis" of the calibration: [0, 0, 1] for a spin, [1, 0, 0] for a sweep</source><translation>abra a varredura com o --axis correto, ou corrija "stepper.axis" da calibração: [0, 0, 1] para spin, [1, 0, 0] para sweep</translation></message>
<message><source>%1 line times do not fit a scan of %2 lines</source><translation>%1 tempos de linha não correspondem a uma varredura de %2 linhas</translation></message>
<message><source>give the times of this scan</source><translation>indique os tempos desta varredura</translation></message>
<message><source>OUT OF SPEC: </source><translation>FORA DE TOLERÂNCIA: </translation></message>
<message><source>The pose carries no time, so its age is not known.</source><translation>A pose não tem hora, portanto a sua idade não é conhecida.</translation></message>
<message><source>The start of the scan is not known, so the age of the pose is not either.</source><translation>O início da varredura não é conhecido, portanto a idade da pose também não.</translation></message>
<message><source>the pose is %1 s older than the start of the scan.</source><translation>a pose é %1 s mais antiga que o início da varredura.</translation></message>
<message><source>the tilt of the head changed by %1 degrees while it scanned, more than %2.</source><translation>a inclinação da cabeça mudou %1 graus durante a varredura, mais de %2.</translation></message>
<message><source>The calibration does not give %1, so 0 is used: add what is missing (Scan &gt; Pose and Mounting, page Mounting).</source><translation>A calibração não dá %1; 0 é usado: acrescente o que falta (Varredura &gt; Pose e montagem, página Montagem).</translation></message>
<message><source>%1 of %2 lines were measured before the first or after the last pose and were given the nearest one.</source><translation>%1 de %2 linhas foram medidas antes da primeira ou depois da última pose e receberam a mais próxima.</translation></message>
<message><source>the poses move the base at %1 m/s between two lines, faster than any machine under ground.</source><translation>as poses movem a base a %1 m/s entre duas linhas, mais rápido que qualquer máquina subterrânea.</translation></message>
<message><source>the zone "%1" does not exist: UTM has zones 1 to 60.</source><translation>a zona "%1" não existe: UTM tem as zonas 1 a 60.</translation></message>
<message><source>an easting of %1 m is outside of every UTM zone: check whether easting and northing are exchanged.</source><translation>uma coordenada leste de %1 m está fora de toda zona UTM: verifique se leste e norte estão trocados.</translation></message>
<message><source>there is no pose</source><translation>não há pose</translation></message>
<message><source>give readings of inclinometer and TALIN</source><translation>indique leituras de inclinômetro e TALIN</translation></message>
<message><source>the angles of the stepper are assumed, so E, N and RL may be wrong: give mounting, step and angle of the first line.</source><translation>os ângulos do motor de passo são supostos, então E, N e RL podem estar errados: indique a montagem, o passo e o ângulo da primeira linha.</translation></message>
<message><source>the base moved and the times of the lines are not known</source><translation>a base se moveu e os tempos das linhas não são conhecidos</translation></message>
<message><source>add "scan_start" and "scan_end" to the pose file</source><translation>acrescente "scan_start" e "scan_end" ao arquivo de pose</translation></message>
<message><source>a pose needs the robot's calibration</source><translation>uma pose precisa da calibração do robô</translation></message>
<message><source>--calibration replaces the calibration in %1.</source><translation>--calibration substitui a calibração de %1.</translation></message>
<message><source>The pose in %1 replaces the place that the file gives: E %2, N %3 m in place of E %4, N %5 m.</source><translation>A pose de %1 substitui o lugar que o arquivo dá: E %2, N %3 m em vez de E %4, N %5 m.</translation></message>
<message><source>mine grid</source><translation>coordenadas da mina</translation></message>
<message><source>local metres from the mine grid origin</source><translation>metros locais desde a origem da grade da mina</translation></message>
<message><source>save the scan again, or remove "placement"</source><translation>salve de novo a varredura, ou remova "placement"</translation></message>
<message><source>must not be where the pivot is</source><translation>não deve estar onde está o pivô</translation></message>
<message><source>"placement" must be an object {...}</source><translation>"placement" deve ser um objeto {...}</translation></message>
<message><source>must be a rotation and a translation, twelve numbers</source><translation>deve ser uma rotação e uma translação, doze números</translation></message>
<message><source>must hold one pose or %1, one per line</source><translation>deve conter uma pose ou %1, uma por linha</translation></message>
<message><source>must hold rotations and translations, twelve numbers each</source><translation>deve conter rotações e translações, doze números cada uma</translation></message>
<message><source>and "%1" exclude each other</source><translation>e «%1» se excluem</translation></message>
<message><source>needs a "time" in every reading when "sweep" is "moving"</source><translation>precisa de um "time" em cada leitura quando "sweep" é "moving"</translation></message>
<message><source>must be in the order of time</source><translation>deve estar na ordem do tempo</translation></message>
<message><source>comes before "scan_start"</source><translation>vem antes de "scan_start"</translation></message>
<message><source>; a scanner that hangs has "viewing": "down" in its calibration</source><translation>; um scanner pendurado tem "viewing": "down" em sua calibração</translation></message>
<message><source>; a magnetic bearing is converted as the same page says</source><translation>; um rumo magnético é convertido como diz a mesma página</translation></message>
<message><source>this is a pose of 3DTK and not of EdgeScan</source><translation>esta é uma pose do 3DTK e não do EdgeScan</translation></message>
<message><source>give a pose file as in docs/reference/coordinates.md</source><translation>indique um arquivo de pose como em docs/reference/coordinates.md</translation></message>
<message><source>write easting, northing and level, such as 498765.432; 5150123.456; 287.654</source><translation>escreva este, norte e nível, como 498765.432; 5150123.456; 287.654</translation></message>
<message><source>the line holds %1 and a place has three, with a heading four, with pitch and roll six</source><translation>a linha contém %1 e um lugar tem três, com rumo quatro, com arfagem e rolagem seis</translation></message>
<message><source>the line is empty</source><translation>a linha está vazia</translation></message>
<message><source>%1 may be one number with a comma for thousands, or two numbers</source><translation>%1 pode ser um número com vírgula de milhares, ou dois números</translation></message>
<message><source>leave that comma out, or write blanks between the numbers</source><translation>tire essa vírgula, ou escreva espaços entre os números</translation></message>
<message><source>the first of four whole numbers may be the point's or the easting</source><translation>o primeiro de quatro números inteiros pode ser o do ponto ou o este</translation></message>
<message><source>leave the point's number out, or write decimals</source><translation>tire o número do ponto, ou escreva decimais</translation></message>
<message><source>How a motor turned the scanner was not said in full. ASSUMED: </source><translation>Não foi indicado por completo como um motor girou o scanner. SUPOSTO: </translation></message>
<message><source>the axis (</source><translation>o eixo (</translation></message>
<message><source>, seen in the ranges)</source><translation>, visto nas distâncias)</translation></message>
<message><source>the step from line to line (</source><translation>o passo de linha a linha (</translation></message>
<message><source>the angle of the first line (</source><translation>o ângulo da primeira linha (</translation></message>
<message><source>the file gives points and not angles</source><translation>o arquivo dá pontos e não ângulos</translation></message>
<message><source>scan of a file</source><translation>varredura de um arquivo</translation></message>
<message><source>no file holds more</source><translation>nenhum arquivo contém mais</translation></message>
<message><source>Angle of the first beam [degrees]</source><translation>Ângulo do primeiro feixe [graus]</translation></message>
<message><source>Angle from beam to beam [degrees]</source><translation>Ângulo de um feixe ao seguinte [graus]</translation></message>
<message><source>Angle of the first line [degrees]</source><translation>Ângulo da primeira linha [graus]</translation></message>
<message><source>Angle from line to line [degrees]</source><translation>Ângulo de uma linha à seguinte [graus]</translation></message>
<message><source>Unit of the numbers in the file; replaces the one that the file gives</source><translation>Unidade dos números do arquivo; substitui a que o arquivo dá</translation></message>
<message><source>Millimetres per number in the file</source><translation>Milímetros por número do arquivo</translation></message>
<message><source>Cells of a cloud that is projected [degrees]; else from the spacing of its points</source><translation>Células de uma nuvem que é projetada [graus]; senão, pelo espaçamento dos seus pontos</translation></message>
<message><source>What the stepper turns about: spin (viewing direction) or sweep (0/180 degree line)</source><translation>Em torno de que gira o motor de passo: spin (direção de visada) ou sweep (linha 0/180 graus)</translation></message>
<message><source>Place of the scanner for a cloud without a grid, as X,Y,Z [m]</source><translation>Lugar do scanner para uma nuvem sem grade, como X,Y,Z [m]</translation></message>
<message><source>Points without a scanner grid: project them about the sensor (auto), do so without looking for a grid (always), or refuse them (never)</source><translation>Pontos que não estão em nenhuma grade de scanner: projetá-los em torno do sensor (auto), fazê-lo sem procurar uma grade (always), ou recusá-los (never)</translation></message>
<message><source>Correct the angles of beams that were interlaced from two passes, and of lines at which the stepper slipped</source><translation>Corrigir os ângulos dos feixes entrelaçados de duas passagens, e das linhas em que o motor de passo escorregou</translation></message>
<message><source>Which scan of a file that holds several, from 0</source><translation>Qual varredura de um arquivo que contém várias, a partir de 0</translation></message>
<message><source>Topic of a ROS bag that is the scan; otherwise a laser that is turned</source><translation>Tópico de um bag do ROS que é a varredura; senão um laser que gira</translation></message>
<message><source>Joint of a ROS bag that turns the laser; otherwise from the transforms</source><translation>Junta (joint) de um bag do ROS que gira o laser; senão, as transformações a dão</translation></message>
<message><source>Columns of x, y and z in a list of points, by number from 1 or by name: 2,1,3</source><translation>Colunas de x, y e z em uma lista de pontos, por número a partir de 1 ou por nome: 2,1,3</translation></message>
<message><source>Take a value or point that repeats exactly, far apart from the rest, as measured and not as no return</source><translation>Tomar um valor ou ponto que se repete exatamente, longe do resto, como medido e não como sem retorno</translation></message>
<message><source>Pose file of the scan; a recording may hold its own</source><translation>Arquivo de pose da varredura; uma gravação pode conter o seu</translation></message>
<message><source>Calibration file of the robot; a recording may hold its own</source><translation>Arquivo de calibração do robô; uma gravação pode conter o seu</translation></message>
<message><source>must not be 0</source><translation>não deve ser 0</translation></message>
<message><source>%1, or a number of %2</source><translation>%1, ou um número de %2</translation></message>
<message><source>"%1" is not one of its values</source><translation>«%1» não é um de seus valores</translation></message>
<message><source>from %1 to %2%3</source><translation>de %1 a %2%3</translation></message>
<message><source>give three numbers %1: X,Y,Z</source><translation>indique três números %1: X,Y,Z</translation></message>
<message><source>give a whole number %1</source><translation>indique um número inteiro %1</translation></message>
<message><source>give a number %1</source><translation>indique um número %1</translation></message>
<message><source> that is not 0</source><translation> que não seja 0</translation></message>
<message><source>"%1" is not three numbers</source><translation>«%1» não são três números</translation></message>
<message><source>"%1" is not a number</source><translation>«%1» não é um número</translation></message>
<message><source>%1 is out of reason for a %2</source><translation>%1 está fora do razoável para %2</translation></message>
<message><source>%1 holds %2</source><translation>%1 contém %2</translation></message>
<message><source>--scan %1</source><translation>--scan %1</translation></message>
<message><source>use --scan 0</source><translation>use --scan 0</translation></message>
<message><source>use --scan 0 to %1</source><translation>use --scan de 0 a %1</translation></message>
<message><source>--%1 %2 replaces %3, which the file gives.</source><translation>--%1 %2 substitui %3, que o arquivo dá.</translation></message>
<message><source>--%1 has no effect: %2; leave it out.</source><translation>--%1 não tem efeito: %2; deixe-o de fora.</translation></message>
<message><source>what the scan was opened with is damaged</source><translation>aquilo com que a varredura foi aberta está danificado</translation></message>
<message><source>export again</source><translation>exporte de novo</translation></message>
<message><source>verify with the version that made the export</source><translation>verifique com a versão que fez a exportação</translation></message>
<message><source>the file</source><translation>o arquivo</translation></message>
<message><source>one scan</source><translation>uma varredura</translation></message>
<message><source>%1 scans</source><translation>%1 varreduras</translation></message>
<message><source>the scanner</source><translation>o scanner</translation></message>
<message><source>the scanner's answer to %1</source><translation>a resposta do scanner a %1</translation></message>
<message><source>the code of a refusal</source><translation>o código de uma recusa</translation></message>
<message><source>the number of sectors</source><translation>o número de setores</translation></message>
<message><source>the angle step</source><translation>o passo angular</translation></message>
<message><source>the start angle</source><translation>o ângulo inicial</translation></message>
<message><source>the stop angle</source><translation>o ângulo final</translation></message>
<message><source>the value</source><translation>o valor</translation></message>
<message><source>the text</source><translation>o texto</translation></message>
<message><source>the scan frequency</source><translation>a frequência de varredura</translation></message>
<message><source>the channels</source><translation>os canais</translation></message>
<message><source>the remission switch</source><translation>a chave de remissão</translation></message>
<message><source>the remission width</source><translation>a largura de remissão</translation></message>
<message><source>the unit</source><translation>a unidade</translation></message>
<message><source>the encoders</source><translation>os codificadores</translation></message>
<message><source>the position switch</source><translation>a chave de posição</translation></message>
<message><source>the name switch</source><translation>a chave de nome</translation></message>
<message><source>the comment switch</source><translation>a chave de comentário</translation></message>
<message><source>the time switch</source><translation>a chave de tempo</translation></message>
<message><source>the output interval</source><translation>o intervalo de saída</translation></message>
<message><source>the name</source><translation>o nome</translation></message>
<message><source>the version</source><translation>a versão</translation></message>
<message><source>the state</source><translation>o estado</translation></message>
<message><source>the temperature range</source><translation>a faixa de temperatura</translation></message>
<message><source>the time</source><translation>a hora</translation></message>
<message><source>the date</source><translation>a data</translation></message>
<message><source>this is not an answer of a scanner</source><translation>isto não é uma resposta de um scanner</translation></message>
<message><source>byte 0 of the telegram</source><translation>byte 0 do telegrama</translation></message>
<message><source>an answer without a name</source><translation>uma resposta sem nome</translation></message>
<message><source>byte 4 of the telegram</source><translation>byte 4 do telegrama</translation></message>
<message><source>access to the method is denied, log in first</source><translation>o acesso ao método é negado, faça login primeiro</translation></message>
<message><source>the method is not known</source><translation>o método não é conhecido</translation></message>
<message><source>the variable is not known</source><translation>a variável não é conhecida</translation></message>
<message><source>not possible now, or a value is out of its range</source><translation>não é possível agora, ou um valor está fora de seu intervalo</translation></message>
<message><source>the arguments are wrong in number or form</source><translation>os argumentos estão errados em número ou forma</translation></message>
<message><source>unknown error</source><translation>erro desconhecido</translation></message>
<message><source>the telegram is too long</source><translation>o telegrama é longo demais</translation></message>
<message><source>the telegram is too short</source><translation>o telegrama é curto demais</translation></message>
<message><source>the type is not known</source><translation>o tipo não é conhecido</translation></message>
<message><source>writing the variable is denied, log in first</source><translation>escrever a variável é negado, faça login primeiro</translation></message>
<message><source>the command is not known to the name server</source><translation>o servidor de nomes não conhece o comando</translation></message>
<message><source>the CoLa command is not known</source><translation>o comando CoLa não é conhecido</translation></message>
<message><source>the method is still busy</source><translation>o método ainda está ocupado</translation></message>
<message><source>an array is out of its bounds</source><translation>uma tabela sai de seus limites</translation></message>
<message><source>the event is not known</source><translation>o evento não é conhecido</translation></message>
<message><source>a CoLa A value is too large</source><translation>um valor CoLa A é grande demais</translation></message>
<message><source>a CoLa A character is invalid</source><translation>um caractere CoLa A não é válido</translation></message>
<message><source>no message</source><translation>nenhuma mensagem</translation></message>
<message><source>no answer</source><translation>nenhuma resposta</translation></message>
<message><source>internal error</source><translation>erro interno</translation></message>
<message><source>hub address is corrupted</source><translation>o endereço do hub está corrompido</translation></message>
<message><source>hub address cannot be decoded</source><translation>o endereço do hub não pode ser decodificado</translation></message>
<message><source>hub address is out of range</source><translation>o endereço do hub está fora de seu intervalo</translation></message>
<message><source>hub address expected</source><translation>esperava-se o endereço do hub</translation></message>
<message><source>asynchronous methods are suppressed</source><translation>os métodos assíncronos estão suprimidos</translation></message>
<message><source>complex arrays are not supported</source><translation>tabelas complexas não são aceitas</translation></message>
<message><source>a reason that is not documented</source><translation>um motivo que não está documentado</translation></message>
<message><source>byte %1 of the telegram</source><translation>byte %1 do telegrama</translation></message>
<message><source>is cut off</source><translation>está cortado</translation></message>
<message><source>is not a number of %1 bits</source><translation>não é um número de %1 bits</translation></message>
<message><source>does not end after %1 characters</source><translation>não termina depois de %1 caracteres</translation></message>
<message><source>are cut off</source><translation>estão cortados</translation></message>
<message><source>bridges with encryption are not supported</source><translation>pontes com criptografia não são aceitas</translation></message>
<message><source>write ws://HOST or ws://HOST:PORT</source><translation>escreva ws://HOST ou ws://HOST:PORT</translation></message>
<message><source>"%1://" is not known here</source><translation>«%1://» não é conhecido aqui</translation></message>
<message><source>write HOST or HOST:PORT for a scanner, ws://HOST or ws://HOST:PORT for a robot's Foxglove bridge</source><translation>escreva HOST ou HOST:PORT para um scanner, ws://HOST ou ws://HOST:PORT para a ponte Foxglove de um robô</translation></message>
<message><source>what follows the bracket is not a port</source><translation>o que segue o colchete não é uma porta</translation></message>
<message><source>there is no port behind the colon</source><translation>não há porta depois dos dois-pontos</translation></message>
<message><source>there is no host</source><translation>não há host</translation></message>
<message><source>"%1" is not a port</source><translation>«%1» não é uma porta</translation></message>
<message><source>give a number from 1 to 65535</source><translation>indique um número de 1 a 65535</translation></message>
<message><source>no scanner is given</source><translation>nenhum scanner foi indicado</translation></message>
<message><source>give its IP address or host name</source><translation>indique o seu endereço IP ou nome de host</translation></message>
<message><source>the host name is not known</source><translation>o nome de host é desconhecido</translation></message>
<message><source>check its spelling or use the scanner's IP address</source><translation>verifique como está escrito ou use o endereço IP do scanner</translation></message>
<message><source>the name server does not answer</source><translation>o servidor de nomes não responde</translation></message>
<message><source>use the scanner's IP address</source><translation>use o endereço IP do scanner</translation></message>
<message><source>nothing answers there</source><translation>nada responde nesse endereço</translation></message>
<message><source>the connection is refused</source><translation>a conexão é recusada</translation></message>
<message><source>there is no way to this address</source><translation>não há caminho para este endereço</translation></message>
<message><source>check the cable and the network settings of this computer</source><translation>verifique o cabo e as configurações de rede deste computador</translation></message>
<message><source>cannot connect (%1)</source><translation>não é possível conectar (%1)</translation></message>
<message><source>check the address and the network settings of this computer</source><translation>verifique o endereço e as configurações de rede deste computador</translation></message>
<message><source>check power, cable and the address, and that this computer is in the scanner's network</source><translation>verifique a alimentação, o cabo e o endereço, e se este computador está na rede do scanner</translation></message>
<message><source>check the port (2111 or 2112) and that no other program holds the scanner</source><translation>verifique a porta (2111 ou 2112) e se nenhum outro programa ocupa o scanner</translation></message>
<message><source>a command cannot be sent (%1)</source><translation>um comando não pode ser enviado (%1)</translation></message>
<message><source>check the cable</source><translation>verifique o cabo</translation></message>
<message><source>the scanner closed the connection</source><translation>o scanner fechou a conexão</translation></message>
<message><source>check that a scanner of SICK answers there; a robot's Foxglove bridge is ws://HOST</source><translation>verifique que ali responde um scanner da SICK; a ponte Foxglove de um robô é ws://HOST</translation></message>
<message><source>the name of a channel</source><translation>o nome de um canal</translation></message>
<message><source>the scale of a channel</source><translation>a escala de um canal</translation></message>
<message><source>the offset of a channel</source><translation>o deslocamento de um canal</translation></message>
<message><source>the start angle of a channel</source><translation>o ângulo inicial de um canal</translation></message>
<message><source>the angle step of a channel</source><translation>o passo angular de um canal</translation></message>
<message><source>the number of values of a channel</source><translation>o número de valores de um canal</translation></message>
<message><source>the values of a channel</source><translation>os valores de um canal</translation></message>
<message><source>the number of channels</source><translation>o número de canais</translation></message>
<message><source>the device number</source><translation>o número do aparelho</translation></message>
<message><source>the serial number</source><translation>o número de série</translation></message>
<message><source>the device status</source><translation>o estado do aparelho</translation></message>
<message><source>the telegram counter</source><translation>o contador de telegramas</translation></message>
<message><source>the scan counter</source><translation>o contador de varreduras</translation></message>
<message><source>the time since start-up</source><translation>o tempo desde a partida</translation></message>
<message><source>the time of transmission</source><translation>a hora de transmissão</translation></message>
<message><source>the digital inputs</source><translation>as entradas digitais</translation></message>
<message><source>the digital outputs</source><translation>as saídas digitais</translation></message>
<message><source>the layer angle</source><translation>o ângulo da camada</translation></message>
<message><source>the measurement frequency</source><translation>a frequência de medição</translation></message>
<message><source>the number of encoders</source><translation>o número de codificadores</translation></message>
<message><source>an encoder position</source><translation>uma posição de codificador</translation></message>
<message><source>an encoder speed</source><translation>uma velocidade de codificador</translation></message>
<message><source>the position</source><translation>a posição</translation></message>
<message><source>the rotation</source><translation>a rotação</translation></message>
<message><source>the rotation type</source><translation>o tipo de rotação</translation></message>
<message><source>the year</source><translation>o ano</translation></message>
<message><source>the date and time</source><translation>a data e a hora</translation></message>
<message><source>the microsecond</source><translation>o microssegundo</translation></message>
<message><source>the event type</source><translation>o tipo de evento</translation></message>
<message><source>the event's encoder</source><translation>o codificador do evento</translation></message>
<message><source>the event's time</source><translation>a hora do evento</translation></message>
<message><source>the event's angle</source><translation>o ângulo do evento</translation></message>
<message><source>the position flag</source><translation>o indicador de posição</translation></message>
<message><source>the name flag</source><translation>o indicador de nome</translation></message>
<message><source>the device name</source><translation>o nome do aparelho</translation></message>
<message><source>the comment flag</source><translation>o indicador de comentário</translation></message>
<message><source>the comment</source><translation>o comentário</translation></message>
<message><source>the time flag</source><translation>o indicador de hora</translation></message>
<message><source>the event flag</source><translation>o indicador de evento</translation></message>
<message><source>the offset of the channel %1 is %2, which no scanner uses</source><translation>o deslocamento do canal %1 é %2, que nenhum scanner usa</translation></message>
<message><source>the scale of the channel %1 is %2, which no scanner uses</source><translation>a escala do canal %1 é %2, que nenhum scanner usa</translation></message>
<message><source>the scan telegram</source><translation>o telegrama de varredura</translation></message>
<message><source>this is not a scan telegram (LMDscandata)</source><translation>isto não é um telegrama de varredura (LMDscandata)</translation></message>
<message><source>firmware %1</source><translation>firmware %1</translation></message>
<message><source>%1 degrees from %2 to %3</source><translation>%1 graus de %2 a %3</translation></message>
<message><source>something accepts the connection but does not answer in CoLa</source><translation>algo aceita a conexão mas não responde em CoLa</translation></message>
<message><source>check that it is a SICK scanner and the port is 2111 or 2112</source><translation>verifique que é um scanner SICK e que a porta é 2111 ou 2112</translation></message>
<message><source>no answer to "%1"</source><translation>nenhuma resposta a «%1»</translation></message>
<message><source>check the connection</source><translation>verifique a conexão</translation></message>
<message><source>no line was received</source><translation>nenhuma linha foi recebida</translation></message>
<message><source>check that foxglove_bridge runs there; a scanner of SICK is HOST without ws://</source><translation>verifique que foxglove_bridge roda ali; um scanner da SICK é HOST sem ws://</translation></message>
<message><source>check cable, address and port</source><translation>verifique o cabo, o endereço e a porta</translation></message>
<message><source>%1: disconnected.</source><translation>%1: desconectado.</translation></message>
<message><source>%1 Trying again in %2.</source><translation>%1 Nova tentativa em %2.</translation></message>
<message><source>Connecting to %1.</source><translation>Conectando a %1.</translation></message>
<message><source> is sending.</source><translation> envia.</translation></message>
<message><source> is sending again.</source><translation> envia de novo.</translation></message>
<message><source>%1: no scan for %2.</source><translation>%1: nenhuma varredura há %2.</translation></message>
<message><source>%1 accepts the connection; asking what it is.</source><translation>%1 aceita a conexão; perguntando o que é.</translation></message>
<message><source>the scanner refuses to send scans: %1</source><translation>o scanner se recusa a enviar varreduras: %1</translation></message>
<message><source>check what else uses it</source><translation>verifique o que mais o usa</translation></message>
<message><source>no scan for %1</source><translation>nenhuma varredura em %1</translation></message>
<message><source>check the cable and whether the scanner's mirror turns</source><translation>verifique o cabo e se o espelho do scanner roda</translation></message>
<message><source>A telegram came late and was put into its line</source><translation>Um telegrama chegou tarde e foi posto na sua linha</translation></message>
<message><source>telegrams came late and were put into their lines</source><translation>telegramas chegaram tarde e foram postos nas suas linhas</translation></message>
<message><source>A telegram came after its sweep had ended</source><translation>Um telegrama chegou depois do fim da sua varredura</translation></message>
<message><source>telegrams came after their sweep had ended</source><translation>telegramas chegaram depois do fim da sua varredura</translation></message>
<message><source>: not used</source><translation>: não usado</translation></message>
<message><source>A telegram had other beams than the sweep, or was of another layer of the scanner</source><translation>Um telegrama tinha outros feixes que a varredura, ou era de outra camada do scanner</translation></message>
<message><source>telegrams had other beams than the sweep, or were of another layer of the scanner</source><translation>telegramas tinham outros feixes que a varredura, ou eram de outra camada do scanner</translation></message>
<message><source>: no lines of this sweep</source><translation>: não são linhas desta varredura</translation></message>
<message><source>A telegram held no ranges</source><translation>Um telegrama não continha distâncias</translation></message>
<message><source>telegrams held no ranges</source><translation>telegramas não continham distâncias</translation></message>
<message><source>: their lines are lost</source><translation>: as suas linhas estão perdidas</translation></message>
<message><source>The scanner's counters jumped ahead once</source><translation>Os contadores do scanner saltaram para a frente uma vez</translation></message>
<message><source>times the scanner's counters jumped ahead</source><translation>vezes os contadores do scanner saltaram para a frente</translation></message>
<message><source>, by more lines than its clock allows: whether lines were lost there is not known</source><translation>, mais linhas do que seu relógio permite: não se sabe se ali se perderam linhas</translation></message>
<message><source>One of the scanner's counters was set back</source><translation>Um dos contadores do scanner foi atrasado</translation></message>
<message><source>times one of the scanner's counters was set back</source><translation>vezes um dos contadores do scanner foi atrasado</translation></message>
<message><source>: lost lines there are counted by the other one and the clock</source><translation>: as linhas perdidas ali são contadas pelo outro e pelo relógio</translation></message>
<message><source>The scanner's counters stood still for a line</source><translation>Os contadores do scanner pararam durante uma linha</translation></message>
<message><source>times the scanner's counters stood still from line to line</source><translation>vezes os contadores do scanner pararam de uma linha para outra</translation></message>
<message><source>: lost lines cannot be counted there</source><translation>: ali não se podem contar as linhas perdidas</translation></message>
<message><source>The scanner's clock was set while its counters ran on</source><translation>O relógio do scanner foi ajustado enquanto os seus contadores seguiam</translation></message>
<message><source>times the scanner's clock was set while its counters ran on</source><translation>vezes o relógio do scanner foi ajustado enquanto os seus contadores seguiam</translation></message>
<message><source>: the times of lines there are reckoned</source><translation>: as horas das linhas ali são calculadas</translation></message>
<message><source>The scanner's clock stood still for a line</source><translation>O relógio do scanner parou durante uma linha</translation></message>
<message><source>times the scanner's clock stood still from line to line</source><translation>vezes o relógio do scanner parou de uma linha para outra</translation></message>
<message><source>The scanner paused for more than a second</source><translation>O scanner fez uma pausa de mais de um segundo</translation></message>
<message><source>times the scanner paused for more than a second</source><translation>vezes o scanner fez uma pausa de mais de um segundo</translation></message>
<message><source>, and its counters know of no lost line</source><translation>, e os seus contadores não conhecem nenhuma linha perdida</translation></message>
<message><source>The scanner restarted</source><translation>O scanner reiniciou</translation></message>
<message><source>times the scanner restarted</source><translation>vezes o scanner reiniciou</translation></message>
<message><source>: lines lost meanwhile are counted by this computer's clock</source><translation>: as linhas perdidas entretanto são contadas pelo relógio deste computador</translation></message>
<message><source>A telegram brought other echoes than the first one</source><translation>Um telegrama trouxe outros ecos que o primeiro</translation></message>
<message><source>telegrams brought other echoes than the first one</source><translation>telegramas trouxeram outros ecos que o primeiro</translation></message>
<message><source>: their ranges may be of another echo</source><translation>: as suas distâncias podem ser de outro eco</translation></message>
<message><source>The telegrams come from another scanner</source><translation>Os telegramas vêm de outro scanner</translation></message>
<message><source>times the telegrams came from another scanner</source><translation>vezes os telegramas vieram de outro scanner</translation></message>
<message><source>: the sweep is not of one device</source><translation>: a varredura não é de um só aparelho</translation></message>
<message><source>A line was lost between two sweeps</source><translation>Uma linha perdeu-se entre duas varreduras</translation></message>
<message><source>lines were lost between two sweeps</source><translation>linhas perderam-se entre duas varreduras</translation></message>
<message><source> (first at line </source><translation> (primeiro na linha </translation></message>
<message><source> (%1 by the counters)</source><translation> (%1 segundo os contadores)</translation></message>
<message><source>the recording computer's clock, carried on by the scanner's</source><translation>o relógio do computador que gravou, continuado pelo do scanner</translation></message>
<message><source> from line %1 on</source><translation> a partir da linha %1</translation></message>
<message><source>window too dirty to measure through</source><translation>janela suja demais para medir através dela</translation></message>
<message><source>dirty window</source><translation>janela suja</translation></message>
<message><source>none reported</source><translation>nenhuma comunicada</translation></message>
<message><source>first echo that the scanner sent</source><translation>primeiro eco que o scanner enviou</translation></message>
<message><source>last echo that the scanner sent</source><translation>último eco que o scanner enviou</translation></message>
<message><source>, the motor turning on while a line is measured)</source><translation>, o motor continua a girar enquanto uma linha é medida)</translation></message>
<message><source>%1. Give %2 where that is wrong.</source><translation>%1. Indique %2 onde isso estiver errado.</translation></message>
<message><source>lines %1 and others</source><translation>linhas %1 e outras</translation></message>
<message><source>lines %1</source><translation>linhas %1</translation></message>
<message><source>The encoder count of the first line received is taken as the first angle of the sweep.</source><translation>A contagem do encoder na primeira linha recebida é tomada como primeiro ângulo da varredura.</translation></message>
<message><source>The first line received is taken as line 0 of the sweep.</source><translation>A primeira linha recebida é tomada como linha 0 da varredura.</translation></message>
<message><source>Telegrams were lost: %1 (%2 in all).</source><translation>Perderam-se telegramas: %1 (%2 no total).</translation></message>
<message><source>Telegrams had fewer beams than the sweep, the others are lost: %1 (%2 in all).</source><translation>Alguns telegramas tinham menos feixes que a varredura, os outros se perderam: %1 (%2 no total).</translation></message>
<message><source>The line angles are computed from time alone: a change of speed bends the cloud.</source><translation>Os ângulos das linhas são calculados só pelo tempo: uma mudança de velocidade curva a nuvem.</translation></message>
<message><source>The telegrams carry encoder counts, but the number of counts per degree was not given: angles do not follow them.</source><translation>Os telegramas trazem contagens do encoder, mas não se indicou quantas há por grau: os ângulos não as seguem.</translation></message>
<message><source>The scanner lost its encoder count when it restarted: the line angles after that are computed.</source><translation>O scanner perdeu a contagem do encoder ao reiniciar: os ângulos das linhas seguintes são calculados.</translation></message>
<message><source> (from line %1 on).</source><translation> (a partir da linha %1).</translation></message>
<message><source>The scanner reported an error or was not ready</source><translation>O scanner comunicou um erro ou não estava pronto</translation></message>
<message><source>The scanner reported a window too dirty to measure through</source><translation>O scanner comunicou uma janela suja demais para medir</translation></message>
<message><source>The scanner reported a dirty window</source><translation>O scanner comunicou uma janela suja</translation></message>
</context>
</TS>
