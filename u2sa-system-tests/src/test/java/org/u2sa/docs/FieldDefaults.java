package org.u2sa.docs;

import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/** What the fields of a new message hold that are neither required nor optional. */
final class FieldDefaults {
  private FieldDefaults() {}

  /** That of an abstract class is asked of one of its subclasses. */
  static Object of(MessageType<?> type, MessageField<?> field) {
    return MessageTypes.discovered().all().stream()
        .filter(each -> !each.isAbstract())
        .filter(each -> type.messageClass().isAssignableFrom(each.messageClass()))
        .map(each -> inNew(each, field.name()))
        .findFirst()
        .orElseThrow(() -> new AssertionError("no subclass of " + type + " can be made"));
  }

  private static <T extends U2SAData> Object inNew(MessageType<T> type, String field) {
    return type.field(field).orElseThrow().get(type.create()).orElseThrow();
  }
}
