package org.u2sa.scenarios.robosub;

import java.util.List;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/** A task at objects in the vehicle's sight, without a position on the earth (thesis 4.3.1.3). */
public class SubTask extends GoalInformation {
  private static final Schema<SubTask> SCHEMA =
      Schema.of(SubTask.class, SubTask::new, GoalInformation.TYPE);
  private static final ValueField<SubTask, List<String>> OBJECT_TYPES =
      SCHEMA.optionalTexts("objectTypes");
  private static final NumberField<SubTask> SPEED = SCHEMA.optionalNumber("speed", "m/s", 0.01);

  public static final MessageType<SubTask> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends SubTask> type() {
    return TYPE;
  }

  /** Types of the objects that the task needs, such as "red buoy"; the task defines their order. */
  public List<String> objectTypes() {
    List<String> types = get(OBJECT_TYPES);
    return types == null ? List.of() : types;
  }

  /** Speed of the approach [m/s]; 0.4 if unset. */
  public double speed() {
    return get(SPEED).orElse(0.4);
  }

  @Override
  public SubTask copy() {
    return (SubTask) super.copy();
  }
}
