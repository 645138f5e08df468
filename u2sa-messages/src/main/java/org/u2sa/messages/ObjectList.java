package org.u2sa.messages;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** The objects that matter to the mission (thesis 3.2.3.3). */
public final class ObjectList extends U2SAData {
  private static final Schema<ObjectList> SCHEMA =
      Schema.of(ObjectList.class, ObjectList::new, U2SAData.TYPE);
  private static final ValueField<ObjectList, List<ObjectDescription>> OBJECTS =
      SCHEMA.messages("objects", ObjectDescription.TYPE);
  private static final ValueField<ObjectList, List<String>> AWAITED =
      SCHEMA.since(3).optionalTexts("awaited");

  public static final MessageType<ObjectList> TYPE = SCHEMA.build();

  @Override
  public MessageType<ObjectList> type() {
    return TYPE;
  }

  /** The objects. */
  public List<ObjectDescription> objects() {
    return require(OBJECTS);
  }

  public ObjectList objects(List<? extends ObjectDescription> value) {
    return put(OBJECTS, List.copyOf(value));
  }

  /**
   * Sensors whose measurements are missing; if not empty, the objects and the grid may be
   * incomplete. Empty if none are missing, and from senders that predate the field.
   */
  public List<String> awaited() {
    List<String> value = get(AWAITED);
    return value == null ? List.of() : value;
  }

  public ObjectList awaited(List<String> value) {
    return put(AWAITED, List.copyOf(value));
  }
}
