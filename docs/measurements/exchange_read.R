# Reads an export of EdgeScan with R, sf or terra, and saves it again: Rscript exchange_read.R LIBRARY FILE OUT [SAVED]. As exchange_read.py.
given <- commandArgs(TRUE)
file <- given[2]
if (startsWith(basename(file), "rocks.")) {
  if (given[1] == "sf") {
    shapes <- sf::st_read(file, quiet = TRUE)
    kinds <- table(as.character(sf::st_geometry_type(shapes)))
    system <- sf::st_crs(shapes)$Name
    cat(paste(kinds, names(kinds), collapse = ", "), "; ", if (is.na(system)) "no coordinate system" else system, sep = "")
  } else {
    rocks <- read.csv(file)
    cat(nrow(rocks), " rows, ", ncol(rocks), " columns, ", sum(sapply(rocks[, 5:7], is.numeric)), " of 3 coordinates as numbers", sep = "")
  }
  quit()
}
text <- grepl("[.](csv|xyz)$", file)
read <- function() if (grepl("[.]csv$", file)) read.csv(file) else read.table(file)
class <- function(cloud) if (is.null(cloud[["class"]])) NA else cloud[["class"]]
if (given[1] == "R") {
  cloud <- read()
  points <- as.matrix(cloud[, 1:3])
  save <- function(saved) write.table(cloud, saved, row.names = FALSE, col.names = grepl("csv$", file), sep = if (grepl("csv$", file)) "," else " ")
} else if (given[1] == "sf") {
  library(sf)
  cloud <- if (text) st_as_sf(read(), coords = 1:3, remove = FALSE) else st_read(file, quiet = TRUE)
  if (!text) cloud <- cloud[cloud$Layer == "CLOUD" | startsWith(cloud$Layer, "EDGE_POINTS"), ]
  points <- st_coordinates(cloud)[, 1:3]
  save <- function(saved) st_write(st_drop_geometry(cloud), saved, quiet = TRUE)
} else {
  library(terra)
  table <- read()
  cloud <- vect(table, geom = names(table)[1:2], keepgeom = TRUE)
  points <- cbind(crds(cloud), values(cloud)[, 3])
  save <- function(saved) write.csv(values(cloud), saved, row.names = FALSE)
}
rows <- cbind(points, NA, NA, NA, class(cloud))
writeBin(as.double(t(rows)), given[3], size = 8, endian = "little")
if (length(given) > 3) save(given[4])
