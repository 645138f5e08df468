package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Asks a service what it publishes and subscribes to (thesis 3.2.2.1). */
public final class FunctionalityRequest extends U2SAData {
  private static final Schema<FunctionalityRequest> SCHEMA =
      Schema.of(FunctionalityRequest.class, FunctionalityRequest::new, U2SAData.TYPE);
  private static final ValueField<FunctionalityRequest, String> SERVICE_NAME =
      SCHEMA.requiredText("serviceName");

  /** The schema. */
  public static final MessageType<FunctionalityRequest> TYPE = SCHEMA.build();

  @Override
  public MessageType<FunctionalityRequest> type() {
    return TYPE;
  }

  /** The service. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  /** Sets {@link #serviceName()}. */
  public FunctionalityRequest serviceName(String value) {
    return put(SERVICE_NAME, value);
  }
}
