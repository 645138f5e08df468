package org.u2sa.gcs.mavlink.event;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.safety.FailsafeAction;

/** Descriptions of the events for stations (COMP_METADATA_TYPE_EVENTS, libevents' schema 2). */
public final class EventMetadata {
  static final String ACTION = "action_t";
  static final String CAUSES = "cause_t";
  private static final int VERSION = 2;
  private static final String COMPONENT = "1"; // the autopilot
  private static final String DESCRIPTION = "description";

  private EventMetadata() {}

  /** The metadata file. */
  public static String json() {
    JsonText events = new JsonText();
    for (EventType each : EventType.values()) {
      events.put(Integer.toString(each.number()), of(each));
    }
    JsonText component =
        new JsonText()
            .put("namespace", "u2sa")
            .put("enums", new JsonText().put(ACTION, actions()).put(CAUSES, causes()))
            .put(
                "event_groups",
                new JsonText().put("default", new JsonText().put("events", events)));
    return new JsonText()
        .put("version", VERSION)
        .put("components", new JsonText().put(COMPONENT, component))
        .line();
  }

  private static JsonText of(EventType event) {
    List<JsonText> arguments = new ArrayList<>();
    for (EventType.Argument each : event.arguments()) {
      arguments.add(new JsonText().put("name", each.name()).put("type", each.type()));
    }
    return new JsonText()
        .put("name", event.name().toLowerCase(Locale.ROOT))
        .put("message", event.message())
        .put(DESCRIPTION, event.description())
        .put("arguments", arguments);
  }

  private static JsonText actions() {
    JsonText entries = new JsonText();
    for (FailsafeAction each : FailsafeAction.values()) {
      entries.put(Integer.toString(each.ordinal()), entry(each.name(), each.name()));
    }
    return new JsonText()
        .put("type", "uint8_t")
        .put(DESCRIPTION, "Action of the vehicle")
        .put("entries", entries);
  }

  private static JsonText causes() {
    JsonText entries = new JsonText();
    for (EventCause each : EventCause.values()) {
      entries.put(Integer.toString(each.bit()), entry(each.name(), each.words()));
    }
    return new JsonText()
        .put("type", "uint32_t")
        .put(DESCRIPTION, "Reasons")
        .put("is_bitfield", true)
        .put("separator", ", ")
        .put("entries", entries);
  }

  private static JsonText entry(String name, String description) {
    return new JsonText().put("name", name.toLowerCase(Locale.ROOT)).put(DESCRIPTION, description);
  }
}
