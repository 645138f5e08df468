package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;

/** Request to every service of a system to announce itself (thesis 3.2.2.1). */
public final class DiscoveryRequest extends U2SAData {
  public static final MessageType<DiscoveryRequest> TYPE =
      Schema.of(DiscoveryRequest.class, DiscoveryRequest::new, U2SAData.TYPE).build();

  @Override
  public MessageType<DiscoveryRequest> type() {
    return TYPE;
  }
}
