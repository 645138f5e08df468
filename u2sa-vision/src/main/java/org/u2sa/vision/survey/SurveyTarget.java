package org.u2sa.vision.survey;

import java.util.List;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A target on the ground, as found in images: its place with standard deviation, shape, colour,
 * letter, the letter's colour and its orientation. What is not known is empty.
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

  /** Reports of targets, each once it will not be seen any better. */
  public static final Channel<SurveyTarget> CHANNEL = Channel.every("survey-targets", TYPE);

  @Override
  public MessageType<SurveyTarget> type() {
    return TYPE;
  }

  /**
   * Shape, colour, letter, letter's colour, and orientation of its top as a point of the compass.
   */
  public List<String> fields() {
    return List.of(get(SHAPE), get(COLOUR), get(LETTER), get(LETTER_COLOUR), get(ORIENTATION));
  }

  SurveyTarget fields(List<String> fields) {
    put(SHAPE, fields.get(0)).put(COLOUR, fields.get(1)).put(LETTER, fields.get(2));
    return put(LETTER_COLOUR, fields.get(3)).put(ORIENTATION, fields.get(4));
  }

  /** Standard deviation of the place, per axis [m]; 0 if unknown. */
  public double sigma() {
    return get(SIGMA).orElse(0.0);
  }

  SurveyTarget sigma(double metres) {
    return put(SIGMA, metres);
  }
}
