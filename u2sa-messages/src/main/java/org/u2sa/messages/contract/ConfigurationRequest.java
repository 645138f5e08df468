package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;

/** Request to a service for its configuration (thesis 3.2.1.1). */
public final class ConfigurationRequest extends ServiceMessage<ConfigurationRequest> {
  private static final Schema<ConfigurationRequest> SCHEMA =
      Schema.of(ConfigurationRequest.class, ConfigurationRequest::new, U2SAData.TYPE)
          .requiring(SERVICE_NAME);

  public static final MessageType<ConfigurationRequest> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConfigurationRequest> type() {
    return TYPE;
  }
}
