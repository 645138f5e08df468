package org.u2sa.benchmarks.mqtt;

import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import org.HdrHistogram.Histogram;

/**
 * The listening half of whatever way it is told to, with the times that messages took. As a program
 * it takes its orders from standard input, a line each, and answers each with a line.
 */
final class Listener implements Way.Sink {
  static final long LONGEST_NANOS = 60_000_000_000L;
  static final int DIGITS = 3;

  private final Progress progress;
  private final Histogram took = new Histogram(LONGEST_NANOS, DIGITS); // guarded by this
  private long count; // guarded by this
  private Way way;
  private Usage before;

  Listener(Path progress) throws IOException {
    this.progress = new Progress(progress);
  }

  /** What this process has used so far. */
  record Usage(long cpuNanos, long allocatedBytes) {
    static Usage now() {
      ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
      long allocated = 0;
      for (long bytes : threads.getThreadAllocatedBytes(threads.getAllThreadIds())) {
        allocated += Math.max(0, bytes);
      }
      return new Usage(
          ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
              .getProcessCpuTime(),
          allocated);
    }

    Usage since(Usage earlier) {
      return new Usage(cpuNanos - earlier.cpuNanos, allocatedBytes - earlier.allocatedBytes);
    }

    Usage and(Usage other) {
      return new Usage(cpuNanos + other.cpuNanos, allocatedBytes + other.allocatedBytes);
    }
  }

  @Override
  public synchronized void arrived(long sentNanos) {
    took.recordValue(Math.max(0, Math.min(LONGEST_NANOS, System.nanoTime() - sentNanos)));
    count++;
    progress.count(count);
  }

  /** Obeys "open WAY PORT BYTES QUALITY", "begin", "report" or "close"; returns the answer. */
  String obey(String order) throws Exception {
    String[] words = order.split(" ");
    switch (words[0]) {
      case "open" -> {
        Ways.Load load = new Ways.Load(Integer.parseInt(words[3]), Integer.parseInt(words[4]));
        way = Ways.listening(words[1], Integer.parseInt(words[2]), load, this);
      }
      case "begin" -> begin();
      case "report" -> {
        return report();
      }
      case "close" -> way.close();
      default -> throw new IllegalArgumentException("order \"" + order + "\"");
    }
    return "done";
  }

  /** For a way whose halves are one object. */
  void open(Way both) {
    way = both;
  }

  private synchronized void begin() {
    took.reset();
    count = 0;
    progress.count(0);
    before = Usage.now();
  }

  private synchronized String report() {
    Usage used = Usage.now().since(before);
    ByteBuffer bytes = ByteBuffer.allocate(took.getNeededByteBufferCapacity());
    int length = took.encodeIntoByteBuffer(bytes);
    byte[] histogram = Arrays.copyOf(bytes.array(), length);
    return Base64.getEncoder().encodeToString(histogram)
        + " "
        + used.cpuNanos
        + " "
        + used.allocatedBytes;
  }

  public static void main(String[] args) throws Exception {
    Listener listener = new Listener(Path.of(args[0]));
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String order = in.readLine(); order != null; order = in.readLine()) {
      System.out.println(listener.obey(order));
    }
    System.exit(0);
  }
}
