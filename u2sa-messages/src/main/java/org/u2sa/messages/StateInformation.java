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
 * All or part of a vehicle's state, from a sensor or from the State Estimator (thesis 3.2.3.2,
 * figure 6).
 *
 * <p>48 optional numbers: see {@link StateField}. All have a getter and a setter but the standard
 * deviations of accelerations, for which {@link #number(StateField)} stands. Their axes and senses
 * of rotation are those of {@link #referenceFrame()}; velocities and accelerations are metric in
 * every frame, standard deviations too.
 */
public class StateInformation extends FluidState {
  private static final Schema<StateInformation> SCHEMA =
      Schema.of(StateInformation.class, StateInformation::new, U2SAData.TYPE);
  private static final ValueField<StateInformation, String> SENSOR_NAME =
      SCHEMA.name("sensorName", "");
  private static final ValueField<StateInformation, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final List<NumberField<StateInformation>> NUMBERS = numbers();

  /** The schema. */
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

  /** The sensor or estimator that the state is from; empty until set. */
  public String sensorName() {
    return get(SENSOR_NAME);
  }

  /** Sets {@link #sensorName()}. */
  public StateInformation sensorName(String name) {
    return put(SENSOR_NAME, name);
  }

  /** The axes of position, velocity, acceleration and attitude; GLOBAL until set. */
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  /**
   * Sets {@link #referenceFrame()}; changes no number: for that see {@link #in(ReferenceFrame)}.
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
   * The same state in another frame, as a new message. Among GLOBAL and UTM, between LOCAL_ENU and
   * LOCAL_NED, among the BODY frames. Positions, velocities, accelerations and standard deviations
   * are turned (correlations between the latter are not known and dropped), attitude takes the
   * frame's senses of rotation, motion through the fluid stays along the vehicle's own axes.
   *
   * @throws IllegalArgumentException naming both frames, if this cannot be done without knowing
   *     more
   */
  public StateInformation in(ReferenceFrame frame) {
    return StateConversion.convert(this, frame, null);
  }

  /**
   * As {@link #in(ReferenceFrame)}, and between the earth's frames and the local ones too. A state
   * without position is taken to be at the origin, one without altitude at the origin's; angles
   * that are absent count as 0 in turning the others.
   *
   * @param origin where the local frame's axes start and are level
   * @throws IllegalArgumentException naming both frames, if this cannot be done
   */
  public StateInformation in(ReferenceFrame frame, Geodetic origin) {
    return StateConversion.convert(this, frame, origin);
  }

  @Override
  public StateInformation copy() {
    return (StateInformation) super.copy();
  }
}
