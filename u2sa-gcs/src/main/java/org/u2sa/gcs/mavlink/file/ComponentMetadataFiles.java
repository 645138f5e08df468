package org.u2sa.gcs.mavlink.file;

import io.dronefleet.mavlink.common.ComponentMetadata;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.mavlink.event.EventMetadata;
import org.u2sa.gcs.mavlink.parameter.ParameterMetadata;
import org.u2sa.gcs.mavlink.telemetry.Uptime;
import org.u2sa.gcs.mavlink.vehicle.ServiceConfigurations;
import org.u2sa.interfaces.JsonText;
import org.u2sa.mavlink.MavlinkCrc32;

/**
 * Component metadata (mavlink.io/en/services/component_information): the parameters with text, unit
 * and range, and the meaning of events. Regenerated when a service announces its variables.
 */
public final class ComponentMetadataFiles {
  static final String GENERAL = "general.json";
  static final String PARAMETERS = "parameter.json";
  static final String EVENTS = "events.json";
  static final List<String> NAMES = List.of(GENERAL, PARAMETERS, EVENTS);
  private static final String SCHEME = "mftp:///";
  private static final int TYPE_PARAMETER = 1; // COMP_METADATA_TYPE, as the following
  private static final int TYPE_EVENTS = 4;

  private final ServiceConfigurations configurations;
  private final String systemId;
  private final Uptime uptime;
  private long madeOf = Long.MIN_VALUE; // number of configurations received
  private final byte[] events = EventMetadata.json().getBytes(StandardCharsets.UTF_8);
  private byte[] parameters = new byte[0];
  private byte[] general = new byte[0];

  /**
   * @param systemId the vehicle's ID, which stations show as its model
   */
  public ComponentMetadataFiles(
      ServiceConfigurations configurations, String systemId, Uptime uptime) {
    this.configurations = configurations;
    this.systemId = systemId;
    this.uptime = uptime;
  }

  /** Content of a file; empty if the name is unknown. */
  Optional<byte[]> content(String name) {
    renew();
    return switch (name) {
      case GENERAL -> Optional.of(general);
      case PARAMETERS -> Optional.of(parameters);
      case EVENTS -> Optional.of(events);
      default -> Optional.empty();
    };
  }

  private void renew() {
    long changes = configurations.changes();
    if (changes == madeOf) {
      return;
    }
    madeOf = changes;
    parameters =
        ParameterMetadata.json(configurations.byService()).getBytes(StandardCharsets.UTF_8);
    general =
        new JsonText()
            .put("version", 1)
            .put("vendorName", "U2SA")
            .put("modelName", systemId)
            .put(
                "metadataTypes",
                List.of(
                    entry(TYPE_PARAMETER, PARAMETERS, parameters),
                    entry(TYPE_EVENTS, EVENTS, events)))
            .line()
            .getBytes(StandardCharsets.UTF_8);
  }

  private static JsonText entry(int type, String name, byte[] content) {
    return new JsonText().put("type", type).put("uri", SCHEME + name).put("fileCrc", crc(content));
  }

  private static long crc(byte[] content) {
    return new MavlinkCrc32().update(content).value() & 0xFFFF_FFFFL;
  }

  /** COMPONENT_METADATA; empty until a service has announced its variables. */
  @SuppressWarnings("deprecation") // the library predates the message's final form
  public Optional<Object> message() {
    renew();
    return madeOf == 0
        ? Optional.empty()
        : Optional.of(
            ComponentMetadata.builder()
                .timeBootMs(uptime.millis())
                .fileCrc(crc(general))
                .uri(SCHEME + GENERAL)
                .build());
  }
}
