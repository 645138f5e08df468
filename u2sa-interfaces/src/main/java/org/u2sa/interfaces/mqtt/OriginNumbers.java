package org.u2sa.interfaces.mqtt;

import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.messages.schema.Origin;

/** Sequence numbers of a sender's MQTT messages, per topic. Thread-safe. */
public final class OriginNumbers {
  private static final int SENDER_LENGTH = 13; // 48 random bits: unique, and short on the wire

  private final String sender;
  private final Map<String, Stream> streams = new ConcurrentHashMap<>();

  OriginNumbers(String sender) {
    this.sender = sender;
  }

  public static OriginNumbers ofNewSender() {
    return new OriginNumbers(newSender());
  }

  static String newSender() {
    return UUID.randomUUID().toString().substring(0, SENDER_LENGTH);
  }

  /** Sequence of a topic; always the same object. */
  public Stream on(String topic) {
    Stream stream = streams.get(topic); // computeIfAbsent locks even for existing keys
    return stream != null ? stream : streams.computeIfAbsent(topic, name -> new Stream());
  }

  /** Sequence of a topic. Callers hold its lock from taking a number until the message is sent. */
  public final class Stream {
    private long last;

    private Stream() {}

    /** Next number; consumed even if sending fails. */
    public synchronized Origin next() {
      last++;
      return new Origin(sender, last);
    }
  }
}
