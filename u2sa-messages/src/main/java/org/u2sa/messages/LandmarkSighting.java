package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Range and bearing of a landmark at a known position, from the World Modeler to the State
 * Estimator. The position is in {@link #referenceFrame}, on the earth or local; the fields of
 * {@link StateInformation} stay absent, so that a reader unaware of this class receives an empty
 * state.
 */
public class LandmarkSighting extends StateInformation {
  private static final Schema<LandmarkSighting> SCHEMA =
      Schema.of(LandmarkSighting.class, LandmarkSighting::new, StateInformation.TYPE);
  private static final NumberField<LandmarkSighting> LANDMARK_X =
      SCHEMA.since(3).optionalCoordinate("landmarkX");
  private static final NumberField<LandmarkSighting> LANDMARK_Y =
      SCHEMA.optionalCoordinate("landmarkY");
  private static final NumberField<LandmarkSighting> RANGE =
      SCHEMA.optionalNumber("range", "m", 0.0);
  private static final NumberField<LandmarkSighting> RANGE_SIGMA =
      SCHEMA.optionalNumber("rangeSigma", "m", 0.0);
  private static final NumberField<LandmarkSighting> BEARING =
      SCHEMA.optionalNumber("bearing", "rad");
  private static final NumberField<LandmarkSighting> BEARING_SIGMA =
      SCHEMA.optionalNumber("bearingSigma", "rad", 0.0);

  /** The schema. */
  public static final MessageType<LandmarkSighting> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends LandmarkSighting> type() {
    return TYPE;
  }

  /** First coordinate of the landmark; longitude [deg] in GLOBAL, else [m]. */
  public OptionalDouble landmarkX() {
    return get(LANDMARK_X);
  }

  /** Sets {@link #landmarkX()}. */
  public LandmarkSighting landmarkX(double value) {
    put(LANDMARK_X, value);
    return this;
  }

  /** Second coordinate of the landmark; latitude [deg] in GLOBAL, else [m]. */
  public OptionalDouble landmarkY() {
    return get(LANDMARK_Y);
  }

  /** Sets {@link #landmarkY()}. */
  public LandmarkSighting landmarkY(double value) {
    put(LANDMARK_Y, value);
    return this;
  }

  /** Horizontal distance from the vehicle's reference point [m]. */
  public OptionalDouble range() {
    return get(RANGE);
  }

  /** Sets {@link #range()}. */
  public LandmarkSighting range(double metres) {
    put(RANGE, metres);
    return this;
  }

  /** Standard deviation of the range, including the landmark's position error [m]. */
  public OptionalDouble rangeSigma() {
    return get(RANGE_SIGMA);
  }

  /** Sets {@link #rangeSigma()}. */
  public LandmarkSighting rangeSigma(double metres) {
    put(RANGE_SIGMA, metres);
    return this;
  }

  /** Direction from the vehicle's nose [rad], clockwise seen from above. */
  public OptionalDouble bearing() {
    return get(BEARING);
  }

  /** Sets {@link #bearing()}. */
  public LandmarkSighting bearing(double rad) {
    put(BEARING, rad);
    return this;
  }

  /** Standard deviation of the bearing, including the landmark's position error [rad]. */
  public OptionalDouble bearingSigma() {
    return get(BEARING_SIGMA);
  }

  /** Sets {@link #bearingSigma()}. */
  public LandmarkSighting bearingSigma(double rad) {
    put(BEARING_SIGMA, rad);
    return this;
  }

  @Override
  public LandmarkSighting in(ReferenceFrame frame) {
    return in(frame, null);
  }

  /** Converts the landmark's position; a sighting itself has no state. */
  @Override
  public LandmarkSighting in(ReferenceFrame frame, Geodetic origin) {
    LandmarkSighting converted = (LandmarkSighting) copy().referenceFrame(frame);
    if (landmarkX().isEmpty() || landmarkY().isEmpty()) {
      return converted;
    }
    StateInformation place =
        new StateInformation()
            .referenceFrame(referenceFrame())
            .x(landmarkX().getAsDouble())
            .y(landmarkY().getAsDouble())
            .in(frame, origin);
    return converted.landmarkX(place.x().getAsDouble()).landmarkY(place.y().getAsDouble());
  }
}
