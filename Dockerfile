# Skytender in a container: gcs and simvehicle, not as root.
#   docker build -t skytender .
#   docker run --rm -v "$PWD:/work" skytender run demo --lockstep --quiet --out session
FROM python:3.12-slim AS build
# hadolint ignore=DL3008
RUN apt-get update \
    && apt-get install -y --no-install-recommends gcc libc6-dev \
    && rm -rf /var/lib/apt/lists/*
WORKDIR /source
COPY pyproject.toml setup.py MANIFEST.in README.md LICENSE ./
COPY configs configs
COPY skytender skytender
COPY simvehicle simvehicle
COPY gcs gcs
RUN python -m venv /opt/skytender && /opt/skytender/bin/pip install --no-cache-dir .

FROM python:3.12-slim
COPY --from=build /opt/skytender /opt/skytender
RUN useradd --create-home --uid 1000 pilot
ENV PATH=/opt/skytender/bin:$PATH
USER 1000:1000
WORKDIR /work
LABEL org.opencontainers.image.title="Skytender" \
      org.opencontainers.image.description="MAVLink ground-station supervisor with software-in-the-loop quadrotors" \
      org.opencontainers.image.licenses="Apache-2.0"
ENTRYPOINT ["gcs"]
CMD ["--help"]
