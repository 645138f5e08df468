package org.u2sa.messages.schema;

/**
 * Sender of an MQTT message and its sequence number on that topic: the key {@code origin} of the
 * payload. Not part of the message; receivers use it to count losses.
 *
 * @param sender globally unique ID of the sending connection, 1…64 characters
 * @param sequence 1 for the sender's first message on the topic, incremented for each further one,
 *     whether sent or not
 */
public record Origin(String sender, long sequence) {
  static final String KEY = "origin";
  static final int ELEMENTS = 2;
  private static final int SENDER_LENGTH = 64;

  /** Rejects ambiguous values. */
  public Origin {
    if (sender.isEmpty() || sender.length() > SENDER_LENGTH) {
      throw new IllegalArgumentException(
          "sender: expected 1…" + SENDER_LENGTH + " characters, not " + sender.length());
    }
    if (sequence < 1) {
      throw new IllegalArgumentException("sequence: " + sequence + " is less than 1");
    }
  }
}
