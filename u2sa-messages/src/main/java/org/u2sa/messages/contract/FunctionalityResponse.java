package org.u2sa.messages.contract;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Publications and subscriptions of a service (thesis 3.2.2.1). */
public final class FunctionalityResponse extends ServiceMessage<FunctionalityResponse> {
  private static final Schema<FunctionalityResponse> SCHEMA =
      Schema.of(FunctionalityResponse.class, FunctionalityResponse::new, U2SAData.TYPE)
          .requiring(SERVICE_NAME);
  private static final ValueField<FunctionalityResponse, List<String>> PUBLISHES =
      SCHEMA.texts("publishes");
  private static final ValueField<FunctionalityResponse, List<String>> SUBSCRIBES =
      SCHEMA.texts("subscribes");

  public static final MessageType<FunctionalityResponse> TYPE = SCHEMA.build();

  @Override
  public MessageType<FunctionalityResponse> type() {
    return TYPE;
  }

  /** Each "channel/TypeChain". */
  public List<String> publishes() {
    return require(PUBLISHES);
  }

  public FunctionalityResponse publishes(List<String> value) {
    return put(PUBLISHES, value);
  }

  /** Each "channel/TypeChain". */
  public List<String> subscribes() {
    return require(SUBSCRIBES);
  }

  public FunctionalityResponse subscribes(List<String> value) {
    return put(SUBSCRIBES, value);
  }
}
