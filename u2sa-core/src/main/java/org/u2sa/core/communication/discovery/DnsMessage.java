package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.nio.Buffer;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** A multicast DNS message (RFC 6762): questions, or answering records. */
record DnsMessage(List<Question> questions, List<DnsRecord> records) {
  static final int LONGEST = 9_000; // maximum bytes (RFC 6762, 17)

  private static final int ANY = 255;
  private static final int INTERNET = 1; // class
  private static final int FLUSH = 0x8000; // bit of the class: replaces earlier records of the name
  private static final int RESPONSE = 0x8400; // flags: authoritative
  private static final int MAX_ENTRIES = 128; // entries read per message
  private static final int MAX_LABELS = 16; // per name
  private static final int POINTER = 0xC0; // marks a compression pointer
  private static final int POINTER_MASK = 0x3F;

  /** A question about the records of a name. */
  record Question(List<String> name, int type) {
    boolean asksFor(DnsRecord record) {
      return (type == record.type() || type == ANY) && name.equals(record.name());
    }
  }

  byte[] bytes() {
    ByteBuffer out = ByteBuffer.allocate(LONGEST);
    out.putShort((short) 0).putShort((short) (records.isEmpty() ? 0 : RESPONSE));
    out.putShort((short) questions.size()).putShort((short) records.size()).putInt(0);
    for (Question question : questions) {
      out.put(DnsRecord.encoded(question.name)).putShort((short) question.type);
      out.putShort((short) INTERNET);
    }
    for (DnsRecord record : records) {
      boolean isShared = record.type() == DnsRecord.POINTER; // other hosts reply to those
      out.put(DnsRecord.encoded(record.name())).putShort((short) record.type());
      out.putShort((short) (isShared ? INTERNET : INTERNET | FLUSH)).putInt(record.ttlS());
      out.putShort((short) record.data().length).put(record.data());
    }
    return Arrays.copyOf(out.array(), out.position());
  }

  /**
   * Reads a message; of a long one, only the first entries.
   *
   * @throws IOException if it is malformed
   */
  static DnsMessage read(byte[] bytes, int length) throws IOException {
    ByteBuffer in = ByteBuffer.wrap(bytes, 0, length);
    try {
      in.getInt(); // ID and flags
      int questions = unsignedShort(in);
      int records = unsignedShort(in) + unsignedShort(in) + unsignedShort(in);
      List<Question> asked = new ArrayList<>();
      for (int i = 0; i < Math.min(questions, MAX_ENTRIES); i++) {
        asked.add(new Question(name(in), unsignedShort(in)));
        in.getShort(); // class
      }
      List<DnsRecord> answered = new ArrayList<>();
      for (int i = 0; i < Math.min(records, MAX_ENTRIES) && questions <= MAX_ENTRIES; i++) {
        answered.add(record(in));
      }
      return new DnsMessage(asked, answered);
    } catch (BufferUnderflowException e) {
      throw new IOException("the message ends early", e);
    }
  }

  private static int unsignedShort(ByteBuffer in) {
    return in.getShort() & 0xFFFF;
  }

  private static DnsRecord record(ByteBuffer in) throws IOException {
    List<String> name = name(in);
    int type = unsignedShort(in);
    in.getShort(); // class
    int ttlS = in.getInt();
    int length = unsignedShort(in);
    int end = in.position() + length;
    if (end > in.limit()) {
      throw new IOException("a record ends after the message");
    }
    byte[] data;
    if (type == DnsRecord.POINTER) {
      data = DnsRecord.encoded(name(in));
    } else if (type == DnsRecord.SERVICE) {
      byte[] head = new byte[DnsRecord.SERVICE_HEAD];
      in.get(head);
      byte[] host = DnsRecord.encoded(name(in));
      data = ByteBuffer.allocate(head.length + host.length).put(head).put(host).array();
    } else {
      data = new byte[length];
      in.get(data);
    }
    place(in, end);
    return new DnsRecord(name, type, ttlS, data);
  }

  /** Reads a name. Pointers to its rest may only lead backwards, so they cannot form a loop. */
  private static List<String> name(ByteBuffer in) throws IOException {
    List<String> labels = new ArrayList<>();
    ByteBuffer from = in;
    int earliest = in.position();
    while (true) {
      int length = from.get() & 0xFF;
      if (length == 0) {
        return List.copyOf(labels);
      }
      if (length >= POINTER) {
        int place = (length & POINTER_MASK) << 8 | from.get() & 0xFF;
        if (place >= earliest) {
          throw new IOException("a name pointer that does not point backwards");
        }
        earliest = place;
        from = in.duplicate();
        place(from, place);
      } else if (length > POINTER_MASK || labels.size() == MAX_LABELS) {
        throw new IOException("a name is too long");
      } else {
        byte[] label = new byte[length];
        from.get(label);
        labels.add(new String(label, StandardCharsets.UTF_8).toLowerCase(Locale.ROOT));
      }
    }
  }

  /** Android 9 has this method in {@link Buffer} only. */
  private static void place(Buffer buffer, int position) {
    buffer.position(position);
  }

  /** Name contained in the data of a pointer or service record. */
  static List<String> target(DnsRecord record) throws IOException {
    int start = record.type() == DnsRecord.SERVICE ? DnsRecord.SERVICE_HEAD : 0;
    try {
      return name(ByteBuffer.wrap(record.data(), start, record.data().length - start));
    } catch (BufferUnderflowException e) {
      throw new IOException("a name ends early", e);
    }
  }
}
