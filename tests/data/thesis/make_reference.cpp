// Makes steps.u16 and reference.json of this folder with OpenCV alone, without any code of EdgeScan:
//   g++ -O1 make_reference.cpp -o make_reference $(pkg-config --cflags --libs opencv4) -lcrypto && ./make_reference
// S in mm, 0 where there is no return; Smin and Smax over valid returns; thesis: gray = clamp(rint(S * 255 / (Smax - Smin)), 0, 255);
// window: gray = clamp(rint((S - Smin) * 255 / (Smax - Smin)), 0, 255), no return 0; cv::GaussianBlur (sigma 0); cv::Canny (L1, aperture
// 3).
#include <opencv2/imgproc.hpp>

#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

int main() {
    constexpr int kLines = 60, kBeams = 80;
    std::vector<std::uint16_t> grid;
    std::uint32_t state = 2463534242U; // xorshift: the same numbers everywhere
    const auto random = [&] {
        state ^= state << 13U;
        state ^= state >> 17U;
        return state ^= state << 5U;
    };
    for (int i = 0; i < kLines; ++i) {
        for (int j = 0; j < kBeams; ++j) {
            double mm = 9000 + 25 * j - 18 * i;                          // a wall that is turned away
            if (i > 8 && i < 30 && j > 10 && j < 34) mm = 5200 + 12 * i; // a box, its front sloping
            if ((i - 38) * (i - 38) + (j - 55) * (j - 55) < 180)         // a boulder
                mm = 3600 + 9 * ((i - 38) * (i - 38) + (j - 55) * (j - 55));
            if (i > 44 && j < 20) mm = 2400 + 60 * (i - 44); // steps
            mm += static_cast<double>(random() % 41) - 20;
            if (random() % 37 == 0) mm = 0;              // no return
            if (i == 50 && j > 60 && j < 70) mm = 32765; // a status code
            grid.push_back(static_cast<std::uint16_t>(mm));
        }
    }
    std::FILE* file = std::fopen("steps.u16", "wb");
    for (const std::uint16_t value : grid) { // little-endian
        std::fputc(value & 0xFF, file);
        std::fputc(value >> 8, file);
    }
    std::fclose(file);
    std::size_t valid = 0;
    double least = 1e9, most = 0;
    for (std::uint16_t& value : grid) {
        if (value == 32765) value = 0;
        if (value == 0) continue;
        ++valid;
        least = std::min<double>(least, value);
        most = std::max<double>(most, value);
    }
    file = std::fopen("reference.json", "w");
    std::fprintf(file, "{\n \"scan\": \"steps.json\",\n \"valid\": %zu,\n \"s_min_mm\": %.1f,\n \"s_max_mm\": %.1f,\n \"cases\": [", valid,
                 least, most);
    const char* comma = "";
    for (const bool thesis : {true, false}) {
        for (const int kernel : {3, 5}) {
            for (const int lower : {5, 10, 20, 40}) {
                cv::Mat gray(kLines, kBeams, CV_8U);
                for (int k = 0; k < kLines * kBeams; ++k) {
                    const double from = thesis ? 0.0 : least, mm = grid[static_cast<std::size_t>(k)];
                    const double level = std::rint((mm - from) * (255.0 / (most - least)));
                    gray.data[k] = mm == 0 ? 0 : static_cast<std::uint8_t>(std::clamp(level, 0.0, 255.0));
                }
                cv::Mat smooth, edges;
                cv::GaussianBlur(gray, smooth, cv::Size(kernel, kernel), 0);
                cv::Canny(smooth, edges, lower, 3 * lower, 3, false);
                unsigned char hash[EVP_MAX_MD_SIZE];
                unsigned size = 0;
                EVP_Digest(edges.data, static_cast<std::size_t>(kLines * kBeams), hash, &size, EVP_sha256(), nullptr);
                std::fprintf(file, "%s\n  {\"gray\": \"%s\", \"kernel\": %d, \"lower\": %d, \"edges\": %d, \"mask_sha256\": \"", comma,
                             thesis ? "thesis" : "window", kernel, lower, cv::countNonZero(edges));
                for (unsigned n = 0; n < size; ++n) std::fprintf(file, "%02x", hash[n]);
                std::fprintf(file, "\"}");
                comma = ",";
            }
        }
    }
    std::fprintf(file, "\n ]\n}\n");
    std::fclose(file);
}
