package org.u2sa.recorder;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionPart;
import org.u2sa.recorder.execution.ExecutionStart;
import org.u2sa.recorder.foxglove.FoxgloveMessages;
import org.u2sa.recorder.mcap.McapWriter;

/**
 * Accepts messages from any thread and writes them on its own. Publishers never wait for the disk:
 * messages that do not fit into the queue are dropped and counted. In simulated time publishers
 * block instead, and nothing is dropped.
 */
final class Recording implements Receiver, LocalBus.Bridge, AutoCloseable {
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final long LOOK_UP_EVERY_MS = 100;
  private static final long SAVE_EVERY_MICROS = 250_000;
  private static final long END_WITHIN_MS = 60_000;
  private static final long STOPPED_WITHIN_MS = 3_000;

  private static final long MAX_BYTES =
      Math.max(8L << 20, Runtime.getRuntime().maxMemory() / 32); // of waiting messages

  /** An item waiting to be written. */
  private interface Waiting {
    /** Arrival time [µs of the run's clock]. */
    long micros();
  }

  private record Taken(Channel<?> channel, U2SAData message, long micros) implements Waiting {}

  private record TakenPart(ExecutionPart part, long micros) implements Waiting {}

  private record TakenStart(String execution, ExecutionStart start, long micros)
      implements Waiting {}

  private final String systemId;
  private final Clock clock;
  private final boolean inRealTime;
  private final Clock stopwatch = new SystemClock();
  private final RecordingFiles files;
  private final RecorderVariables settings;
  private final Consumer<String> trouble;
  private final BlockingQueue<Waiting> waiting;
  private final AtomicLong waitingBytes = new AtomicLong(); // from other processes, in real time
  private final RecordedChannels channels = new RecordedChannels();
  private final RecentMessages recent = new RecentMessages();
  private final FoxgloveMessages foxglove;
  private final AtomicLong dropped = new AtomicLong();
  private final AtomicLong taken = new AtomicLong();
  private final Thread thread = new Thread(this::write, "u2sa-recorder");
  private long failedToWrite; // used by the writing thread only, like those below
  private long unrecordable; // messages that fail for reasons other than the disk
  private long failures; // other failures
  private long savedMicros;
  private long lastNanos; // latest time of the run's clock
  private final CountDownLatch toClose = new CountDownLatch(1);
  private final Thread atExit = new Thread(this::endWithProgram, "u2sa-recorder-exit");

  /** Calls {@code trouble} from any thread with what cannot be recorded. */
  Recording(
      String systemId,
      Clock clock,
      RecorderVariables settings,
      RecordingFiles files,
      Consumer<String> trouble) {
    this.systemId = systemId;
    this.clock = clock;
    this.settings = settings;
    this.files = files;
    this.trouble = trouble;
    inRealTime = clock instanceof SystemClock;
    waiting = new ArrayBlockingQueue<>(settings.waitingAtMost());
    foxglove = new FoxgloveMessages(systemId);
    thread.setDaemon(true);
  }

  void start() {
    WarmUp.run(settings);
    savedMicros = stopwatch.micros();
    lastNanos = clock.micros() * NANOS_PER_MICRO;
    thread.start();
    Runtime.getRuntime().addShutdownHook(atExit);
  }

  private boolean isClosing() {
    return toClose.getCount() == 0;
  }

  /**
   * Shutdown hook: the writing thread ends with the program. Allows a moment for the services' last
   * messages, then completes the file whether or not it was closed.
   */
  private void endWithProgram() {
    try {
      toClose.await(STOPPED_WITHIN_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // so that the file is closed immediately
    }
    close();
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    taken.incrementAndGet();
    int bytes = message.receivedBytes();
    if (inRealTime && waitingBytes.addAndGet(bytes) > MAX_BYTES) {
      waitingBytes.addAndGet(-bytes);
      drop();
    } else if (!take(new Taken(channel, message, clock.micros())) && inRealTime) {
      waitingBytes.addAndGet(-bytes);
    }
  }

  /** Records the start of an execution; from any thread. */
  void begin(String execution, ExecutionStart start) {
    take(new TakenStart(execution, start, clock.micros()));
  }

  /** Records a part of an execution; from any thread. */
  void add(ExecutionPart part) {
    take(new TakenPart(part, part.micros()));
  }

  private boolean take(Waiting one) {
    if (waiting.offer(one)) {
      return true; // also on an interrupted thread
    }
    if (inRealTime || isClosing()) {
      drop();
      return false;
    }
    try {
      waiting.put(one);
      return true;
    } catch (InterruptedException e) {
      drop();
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Records messages of local services on non-standard channels, to which it cannot subscribe. */
  @Override
  public void forward(Channel<?> channel, U2SAData message) {
    if (Channels.named(channel.name()).isEmpty()) {
      receive(channel, message);
    }
  }

  @Override
  public void trouble(String what) {
    trouble.accept(what);
  }

  private void drop() {
    long count = dropped.incrementAndGet();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
      trouble.accept("messages arrive faster than they are recorded: " + count + " dropped so far");
    }
  }

  /** Number of messages so far, accepted or dropped. */
  long taken() {
    return taken.get();
  }

  /** Number of messages dropped because the queue was full. */
  long dropped() {
    return dropped.get();
  }

  private void write() {
    // Attachments come first, and the file exists immediately.
    unlessItFails(() -> files.at(lastNanos, this::nextFile));
    try (DiskSync sync = new DiskSync(trouble)) {
      while (!(isClosing() && waiting.isEmpty())) {
        Waiting next = waiting.poll(LOOK_UP_EVERY_MS, TimeUnit.MILLISECONDS);
        if (next != null) {
          lastNanos = next.micros() * NANOS_PER_MICRO;
          write(next, lastNanos);
          free(next);
        }
        if (stopwatch.micros() - savedMicros >= SAVE_EVERY_MICROS) {
          unlessItFails(() -> save(sync));
          savedMicros = stopwatch.micros();
        }
      }
    } catch (InterruptedException e) {
      trouble.accept("interrupted: " + waiting.size() + " messages are not recorded");
    }
    unlessItFails(() -> files.requirePresent(lastNanos));
    unlessItFails(() -> files.end(lastNanos, counts()));
  }

  private void free(Waiting written) {
    if (inRealTime && written instanceof Taken taken) {
      waitingBytes.addAndGet(-taken.message.receivedBytes());
    }
  }

  private void save(DiskSync sync) {
    files.requirePresent(lastNanos);
    if (inRealTime) {
      files.save(sync);
    }
  }

  /** Runs a step; the recording continues even if it fails. */
  private void unlessItFails(Runnable action) {
    try {
      action.run();
    } catch (RuntimeException | OutOfMemoryError e) {
      if (Long.bitCount(++failures) == 1) { // 1, 2, 4, 8…: retried four times a second
        trouble.accept("recording failed, " + failures + " times so far: " + e);
      }
    }
  }

  private void nextFile() {
    channels.nextFile();
    recent.clear();
  }

  private void write(Waiting next, long nanos) {
    try {
      McapWriter writer = files.at(nanos, this::nextFile);
      if (writer == null) {
        failedToWrite++;
        return;
      }
      if (next instanceof Taken message) {
        write(writer, message, nanos);
      } else if (next instanceof TakenPart taken) {
        write(writer, taken.part, nanos);
      } else if (next instanceof TakenStart begun) {
        begun.start.write(writer, begun.execution, nanos);
      }
    } catch (IOException e) {
      files.failed(e);
    } catch (RuntimeException | OutOfMemoryError e) { // only this message cannot be written
      failedToWrite++;
      if (Long.bitCount(++unrecordable) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
        trouble.accept("cannot be recorded, " + unrecordable + " so far: " + e + ": " + next);
      }
    }
  }

  private void write(McapWriter writer, Taken next, long nanos) throws IOException {
    U2SAData message = next.message;
    long publishedNanos =
        message.timestamp().isPresent() ? message.timestamp().getAsLong() * NANOS_PER_MICRO : nanos;
    if (settings.recordsMessages()) {
      String system = message.systemId().isEmpty() ? systemId : message.systemId();
      recent.add(
          message,
          channels.write(
              writer,
              channels.of(system, next.channel, message),
              nanos,
              publishedNanos,
              message.serialize()));
    }
    if (settings.recordsFoxglove()) {
      foxglove.write(next.channel, message, nanos, view -> write(writer, view, nanos));
    }
  }

  private void write(McapWriter writer, ExecutionPart part, long nanos) throws IOException {
    String topic = ExecutionPart.TOPIC + part.execution();
    String encoding = ExecutionPart.ENCODING;
    RecordedChannels.Track track = channels.of(topic, encoding, encoding, new byte[0]);
    channels.write(writer, track, nanos, nanos, part.bytes(systemId, recent::place));
  }

  private void write(McapWriter writer, FoxgloveMessages.View view, long nanos) throws IOException {
    RecordedChannels.Track track =
        channels.of(view.topic(), "protobuf", view.schemaName(), view.schemaData());
    channels.write(writer, track, nanos, nanos, view.data());
  }

  private Map<String, String> counts() {
    Map<String, String> counts = new LinkedHashMap<>();
    counts.put("messages", Long.toString(taken()));
    counts.put("dropped", Long.toString(dropped()));
    counts.put("not-written", Long.toString(notWritten()));
    return counts;
  }

  /**
   * Number of accepted messages that could not be written, e.g. on a full disk. Call after closing.
   */
  long notWritten() {
    return failedToWrite + files.lost();
  }

  /** Recorded files. Call after closing. */
  List<Path> written() {
    return files.written();
  }

  /** Writes all accepted messages and completes the file. Idempotent. */
  @Override
  public void close() {
    toClose.countDown();
    try {
      thread.join(END_WITHIN_MS);
      if (thread.isAlive()) {
        trouble.accept("the recording's last messages are still being written");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (!thread.isAlive()) { // otherwise the hook waits for the rest
      forgetExit();
    }
  }

  private void forgetExit() {
    try {
      Runtime.getRuntime().removeShutdownHook(atExit);
    } catch (IllegalStateException e) {
      return; // the program is already exiting
    }
  }
}
