# daphnis with its own part of Java 25, as a user without rights, in /data:
#   docker build -t daphnis . && docker run --rm -v "$PWD:/data" -u "$(id -u):$(id -g)" daphnis run ring-patch
FROM maven:3-eclipse-temurin-25 AS build
WORKDIR /src
COPY . .
RUN mvn -B -ntp -q -Pdist -Dmaven.test.skip -pl src -am package && tools/jlink-image /opt/daphnis

FROM debian:stable-slim
# Fonts are for the pictures. Their versions are those of the distribution.
# hadolint ignore=DL3008
RUN apt-get update && apt-get install -y --no-install-recommends fontconfig fonts-dejavu-core \
    && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/daphnis /opt/daphnis
# What the first start leaves beside the jar is made here, where it can be written and times of files are the last ones.
RUN ln -s /opt/daphnis/bin/daphnis /usr/local/bin/daphnis && rm -f /opt/daphnis/*.jsa* && daphnis --version \
    && useradd --uid 1000 --no-create-home daphnis && install -d -o daphnis /data
USER 1000
ENV LANG=C.UTF-8
WORKDIR /data
ENTRYPOINT ["daphnis"]
CMD ["help"]
