package org.u2sa.messages.schema;

/**
 * Who sent a message over MQTT, and which of its messages on that topic it is: the key {@code
 * origin} of the payload. It is no part of the message; a receiver counts by it what it missed.
 *
 * @param sender the sending connection, unique among all that ever were; 1…64 characters
 * @param sequence 1 for the sender's first message on the topic, and one more for each further one,
 *     whether it could be sent or not
 */
public record Origin(String sender, long sequence) {
  static final String KEY = "origin";
  static final int ELEMENTS = 2;
  private static final int SENDER_LENGTH = 64;

  /** Refuses what cannot be told apart. */
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
