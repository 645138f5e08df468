package org.u2sa.core.communication;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/**
 * As much of an MQTT 3.1.1 broker as one client needs, and whatever of it a test wants otherwise:
 * which filters it refuses, and what happens before it answers a subscription. Keeps what is
 * retained over broken connections.
 */
final class ScriptedBroker implements AutoCloseable {
  private static final byte[] NOTHING = {};

  final Map<String, byte[]> retained = new ConcurrentHashMap<>();
  final Set<String> refused = ConcurrentHashMap.newKeySet(); // filters answered with 0x80
  final List<String> subscribed = new CopyOnWriteArrayList<>(); // filters, as they were asked for
  final AtomicInteger longestRequest = new AtomicInteger(); // of (un)subscriptions [B]
  private final List<Socket> sockets = new CopyOnWriteArrayList<>();
  private final ServerSocket server;
  private volatile Consumer<String> beforeAnswer = filter -> {};

  ScriptedBroker() throws IOException {
    server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    daemon(this::accept);
  }

  int port() {
    return server.getLocalPort();
  }

  /** Sets what is done with each filter before its subscription is answered. */
  void beforeAnswer(Consumer<String> action) {
    beforeAnswer = action;
  }

  /** Breaks all connections. */
  void cut() throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
  }

  private static void daemon(Runnable task) {
    Thread thread = new Thread(task, "scripted-broker");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    while (!server.isClosed()) {
      try {
        Socket socket = server.accept();
        sockets.add(socket);
        daemon(() -> serve(socket));
      } catch (IOException e) {
        if (!server.isClosed()) {
          throw new UncheckedIOException(e);
        }
      }
    }
  }

  private void serve(Socket socket) {
    try (socket) {
      DataInputStream in = new DataInputStream(socket.getInputStream());
      DataOutputStream out = new DataOutputStream(socket.getOutputStream());
      while (true) {
        int head = in.readUnsignedByte();
        ByteBuffer body = ByteBuffer.wrap(in.readNBytes(length(in)));
        if (head >> 4 == 8 || head >> 4 == 10) {
          longestRequest.accumulateAndGet(body.remaining(), Math::max);
        }
        switch (head >> 4) {
          case 1 -> answer(out, 0x20, new byte[] {0, 0});
          case 3 -> publish(out, head, body);
          case 8 -> subscribe(out, body);
          case 10 -> answer(out, 0xb0, ByteBuffer.allocate(2).putShort(body.getShort()).array());
          case 12 -> answer(out, 0xd0, NOTHING);
          case 14 -> {
            return;
          }
          default -> throw new IOException("packet type " + (head >> 4) + " is not in the script");
        }
      }
    } catch (IOException e) {
      sockets.remove(socket); // cut, by either side
    }
  }

  private void publish(DataOutputStream out, int head, ByteBuffer body) throws IOException {
    String topic = text(body);
    boolean confirms = (head & 0x06) != 0;
    byte[] number = ByteBuffer.allocate(2).putShort(confirms ? body.getShort() : 0).array();
    byte[] payload = new byte[body.remaining()];
    body.get(payload);
    if ((head & 1) != 0) {
      retained.put(topic, payload);
    }
    if (confirms) {
      answer(out, 0x40, number);
    }
  }

  private void subscribe(DataOutputStream out, ByteBuffer body) throws IOException {
    ByteArrayOutputStream codes = new ByteArrayOutputStream();
    codes.write(body.get());
    codes.write(body.get());
    List<String> granted = new ArrayList<>();
    while (body.hasRemaining()) {
      String filter = text(body);
      byte quality = body.get();
      subscribed.add(filter);
      beforeAnswer.accept(filter);
      if (refused.contains(filter)) {
        codes.write(0x80);
      } else {
        codes.write(quality);
        granted.add(filter);
      }
    }
    answer(out, 0x90, codes.toByteArray());
    for (Map.Entry<String, byte[]> each : retained.entrySet()) {
      if (granted.stream().anyMatch(filter -> matches(filter, each.getKey()))) {
        ByteArrayOutputStream packet = new ByteArrayOutputStream();
        new DataOutputStream(packet).writeUTF(each.getKey());
        packet.write(each.getValue());
        answer(out, 0x31, packet.toByteArray());
      }
    }
  }

  private static boolean matches(String filter, String topic) {
    return filter.endsWith("/#")
        ? (topic + "/").startsWith(filter.substring(0, filter.length() - 1))
        : topic.equals(filter);
  }

  private static String text(ByteBuffer body) {
    byte[] bytes = new byte[body.getShort()];
    body.get(bytes);
    return new String(bytes, StandardCharsets.UTF_8);
  }

  private static int length(DataInputStream in) throws IOException {
    int length = 0;
    int shift = 0;
    int part;
    do {
      part = in.readUnsignedByte();
      length |= (part & 0x7f) << shift;
      shift += 7;
    } while ((part & 0x80) != 0);
    return length;
  }

  private static void answer(DataOutputStream out, int head, byte[] body) throws IOException {
    ByteArrayOutputStream packet = new ByteArrayOutputStream();
    packet.write(head);
    int left = body.length;
    do {
      packet.write(left > 0x7f ? left & 0x7f | 0x80 : left);
      left >>= 7;
    } while (left > 0);
    packet.write(body);
    synchronized (out) {
      out.write(packet.toByteArray());
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
    cut();
  }
}
