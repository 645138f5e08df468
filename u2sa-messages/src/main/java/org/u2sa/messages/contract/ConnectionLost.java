package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/**
 * Published by the broker for a service whose connection broke (MQTT will message). The status is
 * FAILED; readers that do not know this class read it as a health report with that status.
 */
public final class ConnectionLost extends HealthReport {
  private static final Schema<ConnectionLost> SCHEMA =
      Schema.of(ConnectionLost.class, ConnectionLost::new, HealthReport.TYPE).since(2);

  public static final MessageType<ConnectionLost> TYPE = SCHEMA.build();

  @Override
  public MessageType<ConnectionLost> type() {
    return TYPE;
  }
}
