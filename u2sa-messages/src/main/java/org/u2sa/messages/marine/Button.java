package org.u2sa.messages.marine;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Box;

/**
 * A button that a vehicle bumps. The face to press is the one towards psi, so a vehicle approaches
 * with the opposite heading.
 */
public class Button extends Box implements Coloured {
  private static final Schema<Button> SCHEMA =
      Schema.of(Button.class, Button::new, Box.TYPE).since(3);
  private static final ValueField<Button, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<Button> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Button> type() {
    return TYPE;
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public Button colour(Colour colour) {
    return put(COLOUR, colour);
  }

  @Override
  public Button length(double value) {
    return (Button) super.length(value);
  }

  @Override
  public Button width(double value) {
    return (Button) super.width(value);
  }

  @Override
  public Button height(double value) {
    return (Button) super.height(value);
  }

  @Override
  public Button psi(double value) {
    return (Button) super.psi(value);
  }
}
