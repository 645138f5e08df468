package org.u2sa.interfaces.configuration;

/**
 * A value whose type was inferred from its text, as on a command line. A variable declared as a
 * text gets the text.
 *
 * @param value Integer, Double or Boolean
 */
public record InferredValue(String text, Object value) {
  @Override
  public String toString() {
    return text;
  }
}
