#!/bin/sh
# Makes the reference pictures of tests/render/regression_slow_test.cpp, one for each scene:
#   tests/data/reference/make.sh [PROGRAM]      default build/Raytracing; takes some minutes
# 64x64 pixels, float32: R, G, B are the means of 8192 independent samples per pixel, variance.R,
# variance.G and variance.B the sample variances of these means. The header of each picture holds
# the command line. Make them anew only when a picture is meant to change, and say why.
set -eu
cd "$(dirname "$0")/../../.."
program=${1:-build/Raytracing}
for scene in scenes/*.toml; do
  nice "$program" "$scene" --width 64 --height 64 --spp 8192 --seed 1 --sampler independent \
    --reuse 1 --light-sampling solid-angle --variance --quiet \
    --output "tests/data/reference/$(basename "$scene" .toml).exr"
done
