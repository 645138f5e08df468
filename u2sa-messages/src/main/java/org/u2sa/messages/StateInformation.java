package org.u2sa.messages;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * The full or partial state of a vehicle, from a sensor or the State Estimator (thesis 3.2.3.2,
 * figure 6).
 *
 * <p>48 optional numbers: see {@link StateField}. All have a getter and a setter except the
 * standard deviations of accelerations, which are read by {@link #number(StateField)}. Axes and
 * signs of rotation are those of {@link #referenceFrame()}; velocities, accelerations and standard
 * deviations are metric in every frame.
 */
public class StateInformation extends FluidState<StateInformation> {
  private static final Schema<StateInformation> SCHEMA =
      Schema.of(StateInformation.class, StateInformation::new, U2SAData.TYPE);
  private static final ValueField<StateInformation, String> SENSOR_NAME =
      SCHEMA.name("sensorName", "");
  private static final ValueField<StateInformation, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final List<NumberField<StateInformation>> NUMBERS = numbers();

  public static final MessageType<StateInformation> TYPE = SCHEMA.build();

  private static List<NumberField<StateInformation>> numbers() {
    List<NumberField<StateInformation>> fields = new ArrayList<>();
    for (StateField field : StateField.values()) {
      boolean horizontal = field == StateField.X || field == StateField.Y;
      fields.add(
          horizontal
              ? SCHEMA.optionalCoordinate(field.fieldName())
              : SCHEMA.optionalNumber(field.fieldName(), field.unit()));
    }
    return List.copyOf(fields);
  }

  @Override
  public MessageType<? extends StateInformation> type() {
    return TYPE;
  }

  /** Sensor or estimator that produced the state; empty until set. */
  public String sensorName() {
    return get(SENSOR_NAME);
  }

  public StateInformation sensorName(String name) {
    return put(SENSOR_NAME, name);
  }

  /** Axes of position, velocity, acceleration and attitude; defaults to GLOBAL. */
  @Override
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  /**
   * Sets {@link #referenceFrame()} without converting any number; to convert see {@link
   * #in(ReferenceFrame)}.
   */
  public StateInformation referenceFrame(ReferenceFrame frame) {
    return put(REFERENCE_FRAME, frame);
  }

  /** One of the 48 numbers; empty if absent. */
  @Override
  public OptionalDouble number(StateField field) {
    return get(NUMBERS.get(field.ordinal()));
  }

  /**
   * Sets one of the 48 numbers.
   *
   * @throws IllegalArgumentException if not finite
   */
  @Override
  public StateInformation number(StateField field, double value) {
    return put(NUMBERS.get(field.ordinal()), value);
  }

  /**
   * Copy in another frame: among GLOBAL and UTM, between LOCAL_ENU and LOCAL_NED, or among the BODY
   * frames. Positions, velocities, accelerations and standard deviations are rotated (correlations
   * are unknown and dropped), attitude follows the frame's sign conventions, and motion relative to
   * the fluid stays along the vehicle's own axes.
   *
   * @throws IllegalArgumentException naming both frames, if the conversion needs more information
   */
  public StateInformation in(ReferenceFrame frame) {
    return StateConversion.convert(this, frame, null);
  }

  /**
   * Like {@link #in(ReferenceFrame)}, and also between the geographic and the local frames. An
   * absent position counts as the origin, an absent altitude as the origin's; absent angles count
   * as 0 when rotating the others.
   *
   * @param origin origin of the local frame, where its axes are level
   * @throws IllegalArgumentException naming both frames, if no conversion exists
   */
  public StateInformation in(ReferenceFrame frame, Geodetic origin) {
    return StateConversion.convert(this, frame, origin);
  }

  @Override
  public StateInformation copy() {
    return (StateInformation) super.copy();
  }
}
