package org.u2sa.benchmarks.codec;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Time of one message to bytes and back, by our codec and by others. The same message is encoded again and again, of which
 * Protobuf remembers how long it is; {@link ProcessorTime} encodes each once.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class CodecBenchmark {
  @Param({"COMMAND", "STATE", "SCAN"})
  String contents;

  @Param({"OURS", "OURS_COMPACT", "JACKSON_JSON", "MESSAGE_PACK", "PROTOBUF", "JAVA"})
  String peer;

  private Peer.Codec codec;
  private Peer.Encoder encoder;
  private byte[] bytes;

  @Setup
  public void make() throws Exception {
    codec = Peer.valueOf(peer).with(Contents.valueOf(contents));
    encoder = codec.fresh().get();
    bytes = encoder.encode();
    codec.decoder().decode(bytes);
    System.out.println("bytes: " + bytes.length);
  }

  @Benchmark
  public byte[] encode() throws Exception {
    return encoder.encode();
  }

  @Benchmark
  public Object decode() throws Exception {
    return codec.decoder().decode(bytes);
  }
}
