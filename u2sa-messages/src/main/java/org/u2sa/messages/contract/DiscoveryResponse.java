package org.u2sa.messages.contract;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Announcement of a service (thesis 3.2.2.1). */
public final class DiscoveryResponse extends ServiceMessage<DiscoveryResponse> {
  private static final Schema<DiscoveryResponse> SCHEMA =
      Schema.of(DiscoveryResponse.class, DiscoveryResponse::new, U2SAData.TYPE)
          .requiring(SERVICE_NAME);
  private static final ValueField<DiscoveryResponse, String> SERVICE_TYPE =
      SCHEMA.name("serviceType", "");
  private static final ValueField<DiscoveryResponse, ServiceStatus> STATUS =
      SCHEMA.requiredChoice("status", ServiceStatus.class);
  private static final ValueField<DiscoveryResponse, String> HOST = SCHEMA.name("host", "");
  private static final NumberField<DiscoveryResponse> UPTIME =
      SCHEMA.number("uptime", "s", 0.0, 0.0);
  private static final ValueField<DiscoveryResponse, String> VERSION = SCHEMA.name("version", "");
  private static final ValueField<DiscoveryResponse, String> INSTANCE =
      SCHEMA.since(2).optionalName("instance");
  private static final ValueField<DiscoveryResponse, String> CLASS_NAME =
      SCHEMA.optionalName("className");
  private static final ValueField<DiscoveryResponse, List<String>> CHOICES =
      SCHEMA.since(3).optionalTexts("choices");

  public static final MessageType<DiscoveryResponse> TYPE = SCHEMA.build();

  @Override
  public MessageType<DiscoveryResponse> type() {
    return TYPE;
  }

  /** Its role; empty if none. */
  public String serviceType() {
    return require(SERVICE_TYPE);
  }

  public DiscoveryResponse serviceType(String value) {
    return put(SERVICE_TYPE, value);
  }

  /** Life-cycle status. */
  public ServiceStatus status() {
    return require(STATUS);
  }

  public DiscoveryResponse status(ServiceStatus value) {
    return put(STATUS, value);
  }

  /** Host it runs on; empty if unknown. */
  public String host() {
    return require(HOST);
  }

  public DiscoveryResponse host(String value) {
    return put(HOST, value);
  }

  /** Time since it started [s]. */
  public double uptime() {
    return require(UPTIME);
  }

  public DiscoveryResponse uptime(double value) {
    return put(UPTIME, value);
  }

  /** Version of its software; empty if unknown. */
  public String version() {
    return require(VERSION);
  }

  public DiscoveryResponse version(String value) {
    return put(VERSION, value);
  }

  /** ID of this start of the service, as in its health reports. */
  public Optional<String> instance() {
    return Optional.ofNullable(get(INSTANCE));
  }

  public DiscoveryResponse instance(String value) {
    return put(INSTANCE, value);
  }

  /** Fully qualified name of the running class; empty if not applicable. */
  public Optional<String> className() {
    return Optional.ofNullable(get(CLASS_NAME));
  }

  public DiscoveryResponse className(String value) {
    return put(CLASS_NAME, value);
  }

  /** Full names of the classes known to its process that can replace the service. */
  public List<String> choices() {
    List<String> some = get(CHOICES);
    return some == null ? List.of() : some;
  }

  public DiscoveryResponse choices(List<String> value) {
    return put(CHOICES, List.copyOf(value));
  }
}
