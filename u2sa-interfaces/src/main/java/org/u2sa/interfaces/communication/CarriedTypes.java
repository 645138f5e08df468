package org.u2sa.interfaces.communication;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * Which subclasses of its type a channel carries.
 *
 * @param types these and their subclasses; empty: all but those of the service contract
 */
record CarriedTypes(List<MessageType<?>> types) {
  /** Where the service contract's messages are: commands, requests, answers, reports. */
  private static final String CONTRACT = "org.u2sa.messages.contract.";

  static CarriedTypes only(MessageType<?>... types) {
    return new CarriedTypes(List.of(types));
  }

  /**
   * Of a channel of that type, unless it says more. Null if the type alone decides: a channel that
   * names its type, even one of the contract, means it.
   */
  static CarriedTypes by(MessageType<?> type) {
    return type == U2SAData.TYPE ? new CarriedTypes(List.of()) : null;
  }

  boolean include(MessageType<?> other) {
    for (MessageType<?> type = other; type != null; type = type.parent().orElse(null)) {
      if (types.isEmpty() && isOfContract(type)) {
        return false;
      }
      if (types.contains(type)) {
        return true;
      }
    }
    return types.isEmpty();
  }

  /** Whether the type is one of the service contract itself. */
  static boolean isOfContract(MessageType<?> type) {
    return type.messageClass().getName().startsWith(CONTRACT);
  }
}
