# The package in a bare Debian 12, built with its own scripts:
#   docker build -t objectness_segmentation .
#   docker run --rm objectness_segmentation scripts/demo --headless
FROM debian:12
COPY . /objectness_segmentation
WORKDIR /objectness_segmentation
RUN scripts/build && rm -rf /var/lib/apt/lists/*
CMD ["scripts/demo", "--headless"]
