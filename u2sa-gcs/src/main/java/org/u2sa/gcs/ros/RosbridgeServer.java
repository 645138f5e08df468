package org.u2sa.gcs.ros;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import org.u2sa.core.communication.bridge.ClientBridge;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.gcs.socket.ClientSocket;
import org.u2sa.gcs.socket.WebSocketServer;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageTypes;

/** Serves clients of the rosbridge protocol beside the embedded broker. */
final class RosbridgeServer implements ClientBridge {
  private static final int MAX_CLIENTS = // each may occupy megabytes of the vehicle's heap
      (int) Math.max(4, Math.min(16, Runtime.getRuntime().maxMemory() / (8 << 20)));

  private static final int MAX_WAITING = 256; // operations of a client
  private static final int MAX_CALLS = 32; // waiting calls of a client
  private static final double PER_S = 2_000.0; // operations of a client, or KiB of them
  private static final double BURST = 4_000.0; // likewise
  private static final double KIB = 1_024.0;

  private final Setting setting;
  private final RosFrames frames = new RosFrames();
  private final List<RosTopic> topics = RosTopic.all(frames);
  private final RosServices services = new RosServices(topics);
  private final MessageTypes messageTypes = MessageTypes.discovered();
  private final Clock clock;
  private final Lock writing = new ReentrantLock(true);
  private final AtomicLong clients = new AtomicLong();
  private final WebSocketServer server;

  /**
   * @param clock real time, for rates and throttling
   */
  RosbridgeServer(Setting setting, Clock clock) {
    this.setting = setting;
    this.clock = clock;
    server =
        new WebSocketServer(
            new WebSocketServer.Offer(
                setting.address(), "", Set.of(), MAX_CLIENTS, setting.security()),
            Client::new,
            what -> setting.log().accept("rosbridge: " + what));
    setting
        .log()
        .accept(
            "rosbridge: "
                + (setting.security().isPresent() ? "wss" : "ws")
                + "://"
                + setting.address().getHostString()
                + ":"
                + server.address().getPort()
                + "/");
  }

  RosFrames frames() {
    return frames;
  }

  RosServices services() {
    return services;
  }

  MessageTypes messageTypes() {
    return messageTypes;
  }

  /**
   * Held while messages are written for a client, so that all clients together use one core and the
   * memory of one message: serializing a map takes ten times its size.
   */
  Lock writing() {
    return writing;
  }

  Clock clock() {
    return clock;
  }

  Future<?> later(Runnable task, long delayMs) {
    return server.schedule(task, delayMs);
  }

  /**
   * @throws BadInputException if the topic does not exist
   */
  RosTopic topic(String name) {
    String rooted = name.startsWith("/") ? name : "/" + name;
    return topics.stream()
        .filter(topic -> topic.name().equals(rooted))
        .findFirst()
        .orElseThrow(
            () ->
                new BadInputException(
                    "topic \"" + name + "\" does not exist; /rosapi/topics lists all"));
  }

  @Override
  public void close() {
    server.close();
  }

  /** One client, with one thread for its operations and one for its calls, each in order. */
  private final class Client implements WebSocketServer.Conversation {
    private final ClientSocket socket;
    private final RosbridgeSession session;
    private final RosAccount account;
    private final RosBacklog backlog = RosBacklog.incoming();
    private final ThreadPoolExecutor operations;
    private final ThreadPoolExecutor calls;
    private final Allowance rate = new Allowance(PER_S, BURST, clock.micros());

    Client(ClientSocket socket) {
      this.socket = socket;
      String name = "rosbridge-" + clients.incrementAndGet();
      operations = thread(name, MAX_WAITING);
      calls = thread(name + "-calls", MAX_CALLS);
      account = new RosAccount(setting, name, trouble -> warn("broker: " + trouble));
      session = new RosbridgeSession(RosbridgeServer.this, socket, account);
      socket
          .header("Authorization")
          .ifPresent(
              header ->
                  operations.execute(
                      () ->
                          run(
                              "",
                              () -> {
                                account.authorization(header);
                                account.link();
                              })));
    }

    private static ThreadPoolExecutor thread(String name, int waiting) {
      ThreadPoolExecutor one =
          new ThreadPoolExecutor(
              1,
              1,
              1,
              TimeUnit.SECONDS,
              new ArrayBlockingQueue<>(waiting),
              task -> {
                Thread thread = new Thread(task, name);
                thread.setDaemon(true);
                return thread;
              });
      one.allowCoreThreadTimeOut(true);
      return one;
    }

    private void warn(String text) {
      session.status("warning", text, "");
    }

    @Override
    public void text(String text) {
      if (!rate.isOpen(clock.micros())) {
        session.status(
            "error", "more than " + (int) PER_S + " operations, or KiB of them, per second", "");
        socket.close();
        return;
      }
      rate.take(1.0 + text.length() / KIB);
      if (!backlog.hold(text.length())) {
        tooMany("operations", "");
        return;
      }
      try {
        operations.execute(() -> take(text));
      } catch (RejectedExecutionException e) {
        tooMany("operations", "");
        backlog.free(text.length());
      }
    }

    private void tooMany(String what, String id) {
      session.status("error", "too many " + what + " at once; this one is dropped", id);
    }

    /** Parses a text only when its turn comes, because the result takes many times its length. */
    private void take(String text) {
      boolean isCalled = false;
      try {
        RosOperation operation = RosOperation.parse(text);
        String id = operation.idOr("");
        if (operation.name().equals("call_service")) {
          isCalled = call(text, id);
        } else {
          run(id, () -> session.take(operation));
        }
      } catch (BadInputException e) {
        session.status("error", e.getMessage(), "");
      } finally {
        if (!isCalled) {
          backlog.free(text.length());
        }
      }
    }

    /** Queues a call; false if too many are waiting. */
    private boolean call(String text, String id) {
      try {
        calls.execute(() -> answer(text, id));
        return true;
      } catch (RejectedExecutionException e) {
        tooMany("calls", id);
        return false;
      }
    }

    private void answer(String text, String id) {
      try {
        session.call(RosOperation.parse(text));
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt(); // the client has left
      } catch (RuntimeException e) {
        session.status("error", String.valueOf(e.getMessage()), id);
      } finally {
        backlog.free(text.length());
      }
    }

    private void run(String id, Runnable operation) {
      try {
        operation.run();
      } catch (CommunicationException e) {
        session.status("error", e.getMessage(), id);
        socket.close(); // wrong password, or no broker
      } catch (RuntimeException e) {
        session.status("error", String.valueOf(e.getMessage()), id);
      }
    }

    @Override
    public boolean givesWay() {
      return !account.operates();
    }

    @Override
    public void binary() {
      session.status("error", "binary messages are not accepted; expected JSON as text", "");
    }

    @Override
    public void ended() {
      calls.shutdownNow();
      operations.getQueue().clear();
      operations.execute(session::end);
      operations.shutdown();
    }
  }
}
