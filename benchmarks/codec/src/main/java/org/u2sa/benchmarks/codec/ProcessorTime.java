package org.u2sa.benchmarks.codec;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;

/**
 * Processor time of one message to bytes and back, the codecs in turn, each the best of many rounds: for machines that are
 * too busy for time on the clock to mean anything. Each message is encoded once, as services do: Protobuf keeps a message's
 * length from the first time. Arguments: peers, contents, rounds.
 */
public final class ProcessorTime {
  private static final int ROUNDS = 25;
  private static final long A_ROUND_NANOS = 20_000_000; // about
  private static final int FRESH = 100; // messages, made before the time of encoding them is taken
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static volatile Object kept; // so that nothing is optimised away

  private ProcessorTime() {}

  /** One codec with one message, and the least time that it took [ns]. */
  private static final class Timed {
    private final Peer peer;
    private final Peer.Codec codec;
    private final Peer.Encoder[] fresh = new Peer.Encoder[FRESH];
    private final byte[] bytes;
    private double encode = Double.POSITIVE_INFINITY;
    private double decode = Double.POSITIVE_INFINITY;

    Timed(Peer peer, Contents contents) throws Exception {
      this.peer = peer;
      codec = peer.with(contents);
      bytes = codec.fresh().get().encode();
    }

    void round(int times) throws Exception {
      long encoding = 0L;
      for (int batch = 0; batch < times / FRESH; batch++) {
        Arrays.setAll(fresh, i -> codec.fresh().get());
        long began = THREADS.getCurrentThreadCpuTime();
        for (Peer.Encoder each : fresh) {
          kept = each.encode();
        }
        encoding += THREADS.getCurrentThreadCpuTime() - began;
      }
      long between = THREADS.getCurrentThreadCpuTime();
      for (int i = 0; i < times; i++) {
        kept = codec.decoder().decode(bytes);
      }
      long ended = THREADS.getCurrentThreadCpuTime();
      encode = Math.min(encode, encoding / (double) (times / FRESH * FRESH));
      decode = Math.min(decode, (ended - between) / (double) times);
    }

    int timesARound() {
      return (int) Math.max(FRESH, Math.min(100_000, A_ROUND_NANOS / (encode + decode)));
    }
  }

  public static void main(String[] args) throws Exception {
    String[] peers = args.length > 0 ? args[0].split(",") : names(Peer.values());
    String[] contents = args.length > 1 ? args[1].split(",") : names(Contents.values());
    int rounds = args.length > 2 ? Integer.parseInt(args[2]) : ROUNDS;
    System.out.printf(
        Locale.ROOT,
        "codec, processor time, best of %d rounds in turn; load average %.1f, Java %s%n",
        rounds,
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"));
    for (String each : contents) {
      Timed[] timed = new Timed[peers.length];
      for (int i = 0; i < peers.length; i++) {
        timed[i] = new Timed(Peer.valueOf(peers[i]), Contents.valueOf(each));
        timed[i].round(1_000);
      }
      for (int round = 0; round < rounds; round++) {
        for (Timed one : timed) {
          one.round(one.timesARound());
        }
      }
      for (Timed one : timed) {
        System.out.printf(
            Locale.ROOT,
            "%-8s %-16s %5d B, encode %8.0f ns, decode %8.0f ns%n",
            each,
            one.peer,
            one.bytes.length,
            one.encode,
            one.decode);
      }
    }
  }

  private static String[] names(Enum<?>[] constants) {
    return Arrays.stream(constants).map(Enum::name).toArray(String[]::new);
  }
}
