package org.u2sa.recorder;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.recorder.foxglove.FoxgloveMessages;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapWriter;

/**
 * Writes a message to nowhere, so that classes and schemas are loaded before the first message.
 * Loading takes 0.1 s of processor time, which may become seconds on a busy machine, during which
 * nothing would be saved.
 */
final class WarmUp {
  private static final String SYSTEM = "warm-up";

  private WarmUp() {}

  static void run(RecorderVariables settings) {
    StateInformation message = new StateInformation().sensorName(SYSTEM).x(11.0).y(48.0).z(400.0);
    message.psi(0.5).timestamp(0);
    message.freeze();
    RecordedChannels channels = new RecordedChannels();
    channels.nextFile();
    McapOptions options = McapOptions.usual(settings.compression(), SYSTEM);
    try (McapWriter writer = new McapWriter(new Nowhere(), options)) {
      channels.write(
          writer, channels.of(SYSTEM, Channels.STATE, message), 0, 0, message.serialize());
      new FoxgloveMessages(SYSTEM)
          .write(
              Channels.STATE,
              message,
              0,
              view ->
                  channels.write(
                      writer,
                      channels.of(view.topic(), "protobuf", view.schemaName(), view.schemaData()),
                      0,
                      0,
                      view.data()));
    } catch (IOException e) {
      throw new UncheckedIOException("writing nowhere", e);
    }
  }

  /** Discards all bytes, keeping only the size. */
  private static final class Nowhere implements SeekableByteChannel {
    private long position;

    @Override
    public int write(ByteBuffer bytes) {
      int length = bytes.remaining();
      bytes.get(new byte[length]);
      position += length;
      return length;
    }

    @Override
    public int read(ByteBuffer bytes) {
      return -1;
    }

    @Override
    public long position() {
      return position;
    }

    @Override
    public SeekableByteChannel position(long to) {
      position = to;
      return this;
    }

    @Override
    public long size() {
      return position;
    }

    @Override
    public SeekableByteChannel truncate(long to) {
      position = Math.min(position, to);
      return this;
    }

    @Override
    public boolean isOpen() {
      return true;
    }

    @Override
    public void close() {
      // nothing is held
    }
  }
}
