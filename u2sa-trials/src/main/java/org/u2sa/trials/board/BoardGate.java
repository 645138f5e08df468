package org.u2sa.trials.board;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.OneLine;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.ioio.Hosts;

/**
 * Admits hosts to a served board, one at a time: others are refused immediately. Log-ins run on a
 * few separate threads and time out whatever the host sends.
 */
final class BoardGate implements Hosts {
  private static final int BACKLOG = 16;
  private static final int MAX_CANDIDATES = 16;
  private static final int MAX_PER_ADDRESS = 4; // so that one host cannot lock out the others
  private static final int LOOK_EVERY_MS = 500;
  private static final long LOGIN_WITHIN_MICROS = 30 * Clock.MICROS_PER_SECOND;
  private static final int SEND_BUFFER = 1 << 14;

  private final ServerSocket server = new ServerSocket();
  private final Clock clock;
  private final Optional<BoardUsers> users;
  private final int silentAfterMs;
  private final Consumer<String> log;
  private final Consumer<RuntimeException> end;
  private final Refusals refusals;
  private final Map<Socket, Long> candidates = new ConcurrentHashMap<>(); // deadlines
  private final Thread door = new Thread(this::await, "u2sa-board-gate");
  private Host admitted; // waiting for next(), or null; guarded by this
  private Host host; // in session, or null; guarded by this
  private User user; // the host's user, or null; guarded by this
  private boolean closed; // guarded by this

  /**
   * @param users empty: everyone who reaches the address is admitted, unencrypted
   * @param silentAfterS time without a byte after which a host's session ends [s]; 0: never
   * @param log lines for the operator
   * @param end receives the reason if the board cannot continue
   * @throws UncheckedIOException if it cannot listen at the address
   */
  BoardGate(
      InetSocketAddress address,
      Clock clock,
      Optional<BoardUsers> users,
      double silentAfterS,
      Consumer<String> log,
      Consumer<RuntimeException> end)
      throws IOException {
    this.clock = clock;
    this.users = users;
    silentAfterMs = (int) Math.round(silentAfterS * 1e3);
    this.log = log;
    this.end = end;
    refusals = new Refusals(log);
    try {
      server.setReuseAddress(true);
      server.bind(address, BACKLOG);
      server.setSoTimeout(LOOK_EVERY_MS);
    } catch (IOException e) {
      server.close();
      throw e;
    }
    door.setDaemon(true);
    door.start();
  }

  /** Address at which it listens. */
  InetSocketAddress address() {
    return (InetSocketAddress) server.getLocalSocketAddress();
  }

  /** The host in session; empty if there is none. */
  synchronized Optional<String> host() {
    return Optional.ofNullable(host).map(Host::name);
  }

  private void await() {
    while (!isClosed()) {
      try {
        meet(server.accept());
      } catch (SocketTimeoutException e) {
        look();
      } catch (IOException e) {
        rest(e);
      }
    }
  }

  private synchronized void rest(IOException why) {
    try {
      if (!closed) {
        refusals.add("connection not accepted", String.valueOf(why.getMessage()));
        wait(LOOK_EVERY_MS); // e.g. for lack of file descriptors
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Ends log-ins that take too long, and the session of a user who has been removed. */
  private void look() {
    long now = clock.micros();
    for (Iterator<Map.Entry<Socket, Long>> each = candidates.entrySet().iterator();
        each.hasNext(); ) {
      Map.Entry<Socket, Long> candidate = each.next();
      if (now >= candidate.getValue()) {
        each.remove();
        closeQuietly(candidate.getKey());
      }
    }
    Host leaving = null;
    synchronized (this) {
      if (user != null && !users.orElseThrow().isStillAdmitted(user)) {
        log.accept("host " + host.name() + ": its user is no longer admitted");
        leaving = host;
      }
    }
    if (leaving != null) {
      end(leaving);
    }
  }

  private void meet(Socket socket) {
    look();
    String name = socket.getInetAddress().getHostAddress() + ":" + socket.getPort();
    if (isTaken()) {
      refuse(socket, name, "another host is connected");
    } else if (users.isEmpty()) {
      admit(socket, name);
    } else if (candidates.size() >= MAX_CANDIDATES || candidatesAt(socket) >= MAX_PER_ADDRESS) {
      refuse(socket, name, "too many log-ins at once");
    } else {
      candidates.put(socket, clock.micros() + LOGIN_WITHIN_MICROS);
      Thread login = new Thread(() -> admit(socket, name), "u2sa-board-login");
      login.setDaemon(true);
      login.start();
    }
  }

  private long candidatesAt(Socket socket) {
    return candidates.keySet().stream()
        .filter(other -> socket.getInetAddress().equals(other.getInetAddress()))
        .count();
  }

  private void refuse(Socket socket, String name, String why) {
    refusals.add("host refused, " + why, name);
    closeQuietly(socket);
  }

  private void admit(Socket socket, String name) {
    try {
      socket.setTcpNoDelay(true);
      socket.setSendBufferSize(SEND_BUFFER); // so that a host that does not read is soon noticed
      if (users.isEmpty()) {
        socket.setSoTimeout(silentAfterMs);
        take(new Host(name, socket.getInputStream(), socket.getOutputStream(), socket), null);
        return;
      }
      BoardUsers.LoggedIn in = users.get().admit(socket);
      socket.setSoTimeout(silentAfterMs);
      InputStream input = in.socket().getInputStream();
      OutputStream output = in.socket().getOutputStream();
      String who = "\"" + in.user().name() + "\" at " + name;
      // the plain socket: closing an encrypted one waits for its writer
      if (!isTaken()) {
        BoardUsers.tell(in.socket(), "OK");
        take(new Host(who, input, output, socket), in.user());
      } else {
        BoardUsers.tell(in.socket(), "REFUSED another host is connected");
        refuse(socket, who, "another host is connected");
      }
    } catch (IOException | RuntimeException e) {
      boolean isOverdue = users.isPresent() && !candidates.containsKey(socket);
      String why = isOverdue ? "log-in took too long" : String.valueOf(e.getMessage());
      refusals.add("host refused during log-in", name + ": " + OneLine.of(why));
      closeQuietly(socket);
    } finally {
      candidates.remove(socket);
    }
  }

  private void take(Host next, User itsUser) throws IOException {
    synchronized (this) {
      if (closed || host != null) {
        throw new IOException("another host is connected");
      }
      host = next;
      admitted = next;
      user = itsUser;
      notifyAll();
    }
    log.accept("host " + next.name() + " is connected");
  }

  @Override
  public synchronized Host next() throws IOException {
    try {
      while (admitted == null && !closed) {
        wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
    if (closed) {
      throw new IOException("closed");
    }
    Host next = admitted;
    admitted = null;
    return next;
  }

  @Override
  public void ended(Host leaving, String why) {
    synchronized (this) {
      host = null;
      user = null;
    }
    log.accept("host " + leaving.name() + " has left: " + OneLine.of(why));
  }

  @Override
  public void failed(RuntimeException why) {
    end.accept(why);
  }

  private synchronized boolean isTaken() {
    return host != null;
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  private static void end(Host leaving) {
    try {
      leaving.end().close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void closeQuietly(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      return; // no longer used by anyone
    }
  }

  @Override
  public void close() throws IOException {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    server.close();
    candidates.keySet().forEach(BoardGate::closeQuietly);
    users.ifPresent(BoardUsers::close);
  }
}
