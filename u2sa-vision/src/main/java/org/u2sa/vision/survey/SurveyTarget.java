package org.u2sa.vision.survey;

import java.util.List;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A target on the ground, as found in images: its position with standard deviation, shape, colour,
 * letter, the letter's colour and its orientation. Unknown attributes are empty.
 */
public final class SurveyTarget extends ObjectDescription {
  private static final Schema<SurveyTarget> SCHEMA =
      Schema.of(SurveyTarget.class, SurveyTarget::new, ObjectDescription.TYPE);
  private static final ValueField<SurveyTarget, String> SHAPE = SCHEMA.name("shape", "");
  private static final ValueField<SurveyTarget, String> COLOUR = SCHEMA.name("colour", "");
  private static final ValueField<SurveyTarget, String> LETTER = SCHEMA.name("letter", "");
  private static final ValueField<SurveyTarget, String> LETTER_COLOUR =
      SCHEMA.name("letterColour", "");
  private static final ValueField<SurveyTarget, String> ORIENTATION =
      SCHEMA.name("orientation", "");
  private static final NumberField<SurveyTarget> SIGMA = SCHEMA.number("sigma", "m", 0.0, 0.0);

  public static final MessageType<SurveyTarget> TYPE = SCHEMA.build();

  /**
   * Reports of targets, each sent when no better sighting is expected. A person can correct one
   * with another report with the same uid.
   */
  public static final Channel<SurveyTarget> CHANNEL = Channel.every("survey-targets", TYPE);

  @Override
  public MessageType<SurveyTarget> type() {
    return TYPE;
  }

  /** Shape, such as "circle"; empty if unknown. */
  public String shape() {
    return get(SHAPE);
  }

  /** Colour of the shape; empty if unknown. */
  public String colour() {
    return get(COLOUR);
  }

  /** Letter on it; empty if unknown. */
  public String letter() {
    return get(LETTER);
  }

  /** Colour of the letter; empty if unknown. */
  public String letterColour() {
    return get(LETTER_COLOUR);
  }

  /** Compass direction of the letter's top; empty if unknown. */
  public String orientation() {
    return get(ORIENTATION);
  }

  /** The five attributes above, in this order. */
  public List<String> fields() {
    return List.of(shape(), colour(), letter(), letterColour(), orientation());
  }

  /** Sets the five attributes above. */
  public SurveyTarget fields(List<String> fields) {
    put(SHAPE, fields.get(0)).put(COLOUR, fields.get(1)).put(LETTER, fields.get(2));
    return put(LETTER_COLOUR, fields.get(3)).put(ORIENTATION, fields.get(4));
  }

  /** Standard deviation of the position, per axis [m]; 0 if unknown. */
  public double sigma() {
    return get(SIGMA).orElse(0.0);
  }

  SurveyTarget sigma(double metres) {
    return put(SIGMA, metres);
  }
}
