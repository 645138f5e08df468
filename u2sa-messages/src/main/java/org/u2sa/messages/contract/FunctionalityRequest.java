package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;

/** Request for a service's publications and subscriptions (thesis 3.2.2.1). */
public final class FunctionalityRequest extends ServiceMessage<FunctionalityRequest> {
  private static final Schema<FunctionalityRequest> SCHEMA =
      Schema.of(FunctionalityRequest.class, FunctionalityRequest::new, U2SAData.TYPE)
          .requiring(SERVICE_NAME);

  public static final MessageType<FunctionalityRequest> TYPE = SCHEMA.build();

  @Override
  public MessageType<FunctionalityRequest> type() {
    return TYPE;
  }
}
