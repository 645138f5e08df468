import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapChannel;
import org.u2sa.recorder.mcap.McapMessage;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapSchema;
import org.u2sa.recorder.mcap.McapWriter;

/**
 * Messages and bytes a second that the MCAP writer takes, by size of message and compression, into a file of a folder
 * in memory; beside it {@code scripts/recording/throughput.py} measures Python's writer with the same messages.
 * Argument: the folder.
 */
public final class RecordThroughput {
  private static final long BYTES = 400_000_000L;
  private static final int DIFFERENT = 64;

  private RecordThroughput() {}

  public static void main(String[] args) throws IOException {
    Path folder = Path.of(args.length > 0 && Files.isDirectory(Path.of(args[0])) ? args[0] : "/dev/shm");
    for (ChunkCompression compression : ChunkCompression.values()) {
      for (int size : new int[] {100, 1_000, 10_000}) {
        write(folder, compression, size, BYTES / 8); // the virtual machine warms up
        write(folder, compression, size, BYTES);
      }
    }
  }

  private static void write(Path folder, ChunkCompression compression, int size, long bytes) throws IOException {
    byte[][] payloads = new byte[DIFFERENT][size];
    Random random = new Random(1);
    for (byte[] payload : payloads) {
      for (int i = 0; i < size; i++) {
        payload[i] = (byte) (i % 4 == 0 ? random.nextInt(256) : i); // about as compressible as states
      }
    }
    Path file = Files.createTempFile(folder, "throughput", ".mcap");
    int messages = (int) Math.min(4_000_000, bytes / size);
    long began = System.nanoTime();
    try (McapWriter writer =
        new McapWriter(
            FileChannel.open(file, StandardOpenOption.WRITE), McapOptions.usual(compression, "benchmark"))) {
      writer.add(new McapSchema(1, "Bytes", "", new byte[0]));
      writer.add(new McapChannel(1, 1, "bytes", "cbor", Map.of()));
      for (int i = 0; i < messages; i++) {
        writer.add(new McapMessage(1, i, i * 1_000L, i * 1_000L, payloads[i % DIFFERENT]));
      }
    }
    double seconds = (System.nanoTime() - began) / 1e9;
    System.out.printf(
        Locale.ROOT,
        "%-4s %6d B: %5.2f million messages/s, %6.0f MB/s, file %d MB%n",
        compression,
        size,
        messages / seconds / 1e6,
        (double) messages * size / seconds / 1e6,
        Files.size(file) / 1_000_000);
    Files.delete(file);
  }
}
