import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import org.u2sa.messages.StateInformation;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.McapWriter;

/**
 * Messages and bytes a second that the MCAP writer takes, by size of message and compression, into a file of a folder in memory; by time and
 * by processor time, which other processes of a busy machine do not lengthen. {@code scripts/recording/throughput.py} measures Python's
 * writer beside it. Arguments: the folder; compression and size [B] of one row, default: all.
 */
public final class RecordThroughput {
  private static final long BYTES = 400_000_000L;
  private static final int PAYLOAD_BYTES = 8_000_000; // in all: more than LZ4 looks back

  private RecordThroughput() {}

  public static void main(String[] args) throws IOException {
    Path folder = Path.of(args.length > 0 && Files.isDirectory(Path.of(args[0])) ? args[0] : "/dev/shm");
    if (args.length == 3) {
      measure(folder, ChunkCompression.valueOf(args[1]), Integer.parseInt(args[2]));
      return;
    }
    for (ChunkCompression compression : ChunkCompression.values()) {
      for (int size : new int[] {100, 1_000, 10_000}) {
        measure(folder, compression, size);
      }
    }
  }

  private static void measure(Path folder, ChunkCompression compression, int size) throws IOException {
    byte[][] payloads = payloads(size);
    try (OutputStream out = Files.newOutputStream(folder.resolve("payloads-" + size))) { // for Python's
      for (byte[] payload : payloads) {
        out.write(payload);
      }
    }
    write(folder, compression, payloads, BYTES / 2); // the virtual machine warms up
    System.out.println(write(folder, compression, payloads, BYTES));
  }

  /** States of a vehicle that moves, one after the other, cut into pieces of one size. */
  private static byte[][] payloads(int size) {
    byte[][] payloads = new byte[PAYLOAD_BYTES / size][size];
    Random random = new Random(1);
    int state = 0;
    for (byte[] payload : payloads) {
      for (int filled = 0; filled < size; state++) {
        StateInformation message = new StateInformation().sensorName("StateEstimator").x(11.0 + state * 1e-7).y(48.0 + random.nextGaussian() * 1e-6);
        message.z(random.nextGaussian()).psi(state * 1e-3).xDot(random.nextGaussian()).xSigma(0.02).ySigma(0.02);
        message.systemId("ugv");
        message.timestamp(state * 20_000L);
        byte[] bytes = message.serialize();
        int length = Math.min(bytes.length, size - filled);
        System.arraycopy(bytes, 0, payload, filled, length);
        filled += length;
      }
    }
    return payloads;
  }

  private static String write(Path folder, ChunkCompression compression, byte[][] payloads, long bytes) throws IOException {
    int size = payloads[0].length;
    Path file = Files.createTempFile(folder, "throughput", ".mcap");
    int messages = (int) Math.min(4_000_000, bytes / size);
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long began = System.nanoTime();
    long usedBefore = threads.getCurrentThreadCpuTime();
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.WRITE), McapOptions.usual(compression, "benchmark"))) {
      writer.add(new McapSchema(1, "Bytes", "", new byte[0]));
      writer.add(new McapChannel(1, 1, "bytes", "cbor", Map.of()));
      for (int i = 0; i < messages; i++) {
        writer.add(new McapMessage(1, i, i * 1_000L, i * 1_000L, payloads[i % payloads.length]));
      }
    }
    double used = (threads.getCurrentThreadCpuTime() - usedBefore) / 1e9;
    double seconds = (System.nanoTime() - began) / 1e9;
    Files.delete(file);
    return String.format(
        Locale.ROOT,
        "%-4s %6d B: %5.2f million messages/s, %6.0f MB/s; by processor time %5.2f million/s, %6.0f MB/s",
        compression,
        size,
        messages / seconds / 1e6,
        (double) messages * size / seconds / 1e6,
        messages / used / 1e6,
        (double) messages * size / used / 1e6);
  }
}
