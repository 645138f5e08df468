package org.u2sa.report.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Collection;

/** Writes PX4's log format ULog, version 1 (docs.px4.io/main/en/dev_log/ulog_file_format). */
final class UlogWriter {
  private static final byte[] MAGIC = {'U', 'L', 'o', 'g', 0x01, 0x12, 0x35, 1};
  private static final int FLAG_BYTES = 40;
  private static final int MAX_SIZE = 0xFFFF; // of a message
  private static final int HEAD = Short.BYTES + 1;

  private final OutputStream out;

  /** Writes the header. */
  UlogWriter(OutputStream out) throws IOException {
    this.out = out;
    out.write(MAGIC);
    out.write(new byte[Long.BYTES]); // the log starts at time 0
    message('B', new byte[FLAG_BYTES]);
  }

  /** Writes an information message about the log. */
  void info(String name, String value) throws IOException {
    byte[] text = value.getBytes(StandardCharsets.UTF_8);
    byte[] key = ("char[" + text.length + "] " + name).getBytes(StandardCharsets.UTF_8);
    ByteBuffer body = ByteBuffer.allocate(1 + key.length + text.length);
    message('I', body.put((byte) key.length).put(key).put(text).array());
  }

  /** Defines a message format of a time and numbers. All definitions precede the data. */
  void format(String name, Collection<String> numbers) throws IOException {
    StringBuilder text = new StringBuilder(name).append(":uint64_t timestamp;");
    numbers.forEach(number -> text.append("double ").append(number).append(';'));
    message('F', text.toString().getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Announces a source of messages of a format.
   *
   * @param instance number among the sources of this format, 0…255
   * @param id number among all sources, 0…65535
   */
  void source(String format, int instance, int id) throws IOException {
    byte[] name = format.getBytes(StandardCharsets.UTF_8);
    ByteBuffer body = buffer(1 + Short.BYTES + name.length);
    message('A', body.put((byte) instance).putShort((short) id).put(name).array());
  }

  /** Writes a message of a source; NaN where a number is absent. */
  void data(int id, long micros, double[] numbers) throws IOException {
    ByteBuffer body = buffer(Short.BYTES + Long.BYTES + numbers.length * Double.BYTES);
    body.putShort((short) id).putLong(micros);
    for (double number : numbers) {
      body.putDouble(number);
    }
    message('D', body.array());
  }

  private static ByteBuffer buffer(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void message(char type, byte[] body) throws IOException {
    if (body.length > MAX_SIZE) {
      throw new IOException("a message of " + body.length + " bytes; ULog has at most " + MAX_SIZE);
    }
    out.write(buffer(HEAD).putShort((short) body.length).put((byte) type).array());
    out.write(body);
  }
}
