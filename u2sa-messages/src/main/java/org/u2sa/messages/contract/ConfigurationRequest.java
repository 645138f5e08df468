package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Asks a service for its configuration (thesis 3.2.1.1). */
public final class ConfigurationRequest extends U2SAData {
  private static final Schema<ConfigurationRequest> SCHEMA =
      Schema.of(ConfigurationRequest.class, ConfigurationRequest::new, U2SAData.TYPE);
  private static final ValueField<ConfigurationRequest, String> SERVICE_NAME =
      SCHEMA.requiredText("serviceName");

  /** The schema. */
  public static final MessageType<ConfigurationRequest> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationRequest> type() {
    return TYPE;
  }

  /** The service. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  /** Sets {@link #serviceName()}. */
  public ConfigurationRequest serviceName(String value) {
    return put(SERVICE_NAME, value);
  }
}
