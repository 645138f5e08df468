package org.u2sa.interfaces.communication;

import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.messages.schema.Origin;

/** Numbers what one sender sends over MQTT, topic by topic. Safe for all threads. */
public final class OriginNumbers {
  private static final int SENDER_LENGTH = 13; // 48 random bits: unique, and short on the wire

  private final String sender;
  private final Map<String, Stream> streams = new ConcurrentHashMap<>();

  /** Numbers of a sender of that name, which no other ever has. */
  OriginNumbers(String sender) {
    this.sender = sender;
  }

  /** Numbers of a sender that nobody was before. */
  public static OriginNumbers ofNewSender() {
    return new OriginNumbers(newSender());
  }

  static String newSender() {
    return UUID.randomUUID().toString().substring(0, SENDER_LENGTH);
  }

  /** The numbers of one topic; always the same object. */
  public Stream on(String topic) {
    Stream stream = streams.get(topic); // computeIfAbsent takes a lock even if the key is there
    return stream != null ? stream : streams.computeIfAbsent(topic, name -> new Stream());
  }

  /**
   * The numbers of one topic. Who takes a number holds the stream's lock until the message is on
   * its way, so that messages leave in the order of their numbers.
   */
  public final class Stream {
    private long last;

    private Stream() {}

    /** The next number: used up, whether its message can be sent or not. */
    public synchronized Origin next() {
      last++;
      return new Origin(sender, last);
    }
  }
}
