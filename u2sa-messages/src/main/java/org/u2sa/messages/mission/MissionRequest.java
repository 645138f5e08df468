package org.u2sa.messages.mission;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Request to the Mission Manager for the mission's progress. */
public final class MissionRequest extends U2SAData {
  private static final Schema<MissionRequest> SCHEMA =
      Schema.of(MissionRequest.class, MissionRequest::new, U2SAData.TYPE).since(3);
  private static final ValueField<MissionRequest, String> REQUEST_ID =
      SCHEMA.requiredId("requestId");
  private static final ValueField<MissionRequest, Boolean> CLASSES = SCHEMA.optionalFlag("classes");

  public static final MessageType<MissionRequest> TYPE = SCHEMA.build();

  @Override
  public MessageType<MissionRequest> type() {
    return TYPE;
  }

  /** Unique ID, chosen by the sender, that the answer repeats. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public MissionRequest requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** Whether the answer begins with a {@link GoalClass} per class of goals. */
  public boolean classes() {
    return Boolean.TRUE.equals(get(CLASSES));
  }

  public MissionRequest classes(boolean value) {
    return put(CLASSES, value);
  }
}
