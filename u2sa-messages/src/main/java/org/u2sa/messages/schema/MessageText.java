package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.List;

/** Messages as a log shows them. */
final class MessageText {
  private MessageText() {}

  static String of(U2SAData message) {
    List<String> parts = new ArrayList<>();
    for (FieldValue field : message.enumerateFields()) {
      if (field.value().isPresent()) {
        String unit = field.unit().isEmpty() ? "" : " " + field.unit();
        parts.add(field.name() + "=" + field.value().get() + unit);
      }
    }
    List<String> chain = message.typeChain();
    return chain.get(chain.size() - 1) + "{" + String.join(", ", parts) + "}";
  }
}
