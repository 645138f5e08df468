package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/**
 * The last word of a connection that broke: the broker says it in the place of a service that can
 * no longer (MQTT will message). The status is FAILED; who does not know this class reads it as
 * such a health report.
 */
public final class ConnectionLost extends HealthReport {
  private static final Schema<ConnectionLost> SCHEMA =
      Schema.of(ConnectionLost.class, ConnectionLost::new, HealthReport.TYPE).since(2);

  /** The schema. */
  public static final MessageType<ConnectionLost> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConnectionLost> type() {
    return TYPE;
  }
}
