package org.u2sa.core.communication;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * A broker of another make for one client: it holds some messages and hands each, with MQTT's
 * retained flag, to a subscription that begins with the same channel. It returns what the client
 * publishes.
 */
final class RetainingBroker implements AutoCloseable {
  private static final int FIRST_LEVELS = 3; // u2sa, system, channel
  private static final int ID_AT = 10; // behind the protocol's name, level, flags and keep-alive

  private final ServerSocket listening;
  private final Map<String, byte[]> held = new LinkedHashMap<>();
  private final List<IOException> faults = new CopyOnWriteArrayList<>();
  private final Thread thread = new Thread(this::serve, "retaining-broker");
  private Socket client; // written under this
  private volatile String clientId = "";

  RetainingBroker() throws IOException {
    listening = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"));
    thread.setDaemon(true);
  }

  RetainingBroker holding(String topic, byte[] payload) {
    held.put(topic, payload.clone());
    return this;
  }

  int start() {
    thread.start();
    return listening.getLocalPort();
  }

  private void serve() {
    try (Socket socket = listening.accept()) {
      synchronized (this) {
        client = socket;
      }
      DataInputStream in = new DataInputStream(socket.getInputStream());
      while (true) {
        int first = in.readUnsignedByte();
        answer(first, in.readNBytes(length(in)));
      }
    } catch (EOFException | SocketException e) {
      return; // the client has left, or the test is over
    } catch (IOException e) {
      faults.add(e);
    }
  }

  private static int length(DataInputStream in) throws IOException {
    int length = 0;
    for (int shift = 0; ; shift += 7) {
      int digit = in.readUnsignedByte();
      length |= (digit & 0x7f) << shift;
      if (digit <= 0x7f) {
        return length;
      }
    }
  }

  private void answer(int first, byte[] content) throws IOException {
    switch (first >> 4) {
      case 1: // CONNECT
        clientId = text(content, ID_AT);
        send(new byte[] {0x20, 2, 0, 0});
        break;
      case 3: // PUBLISH
        returnToClient(content, (first >> 1 & 3) > 0);
        break;
      case 8: // SUBSCRIBE, of one filter
        send(new byte[] {(byte) 0x90, 3, content[0], content[1], 1});
        handOver(text(content, 2));
        break;
      case 10: // UNSUBSCRIBE
        send(new byte[] {(byte) 0xb0, 2, content[0], content[1]});
        break;
      case 12: // PINGREQ
        send(new byte[] {(byte) 0xd0, 0});
        break;
      default: // what needs no answer here
        break;
    }
  }

  private static String text(byte[] content, int at) {
    int length = (content[at] & 0xff) << 8 | content[at + 1] & 0xff;
    return new String(content, at + 2, length, StandardCharsets.UTF_8);
  }

  private void returnToClient(byte[] content, boolean isNumbered) throws IOException {
    String topic = text(content, 0);
    int at = 2 + topic.getBytes(StandardCharsets.UTF_8).length;
    if (isNumbered) {
      send(new byte[] {0x40, 2, content[at], content[at + 1]}); // PUBACK
      at += 2;
    }
    publish(topic, Arrays.copyOfRange(content, at, content.length), false);
  }

  /** The ID that the client has given itself. */
  String clientId() {
    return clientId;
  }

  private void handOver(String filter) throws IOException {
    for (Map.Entry<String, byte[]> message : held.entrySet()) {
      if (List.of(filter.split("/"))
          .subList(0, FIRST_LEVELS)
          .equals(List.of(message.getKey().split("/")).subList(0, FIRST_LEVELS))) {
        publish(message.getKey(), message.getValue(), true);
      }
    }
  }

  /** QoS 0. */
  void publish(String topic, byte[] payload, boolean retained) throws IOException {
    byte[] name = topic.getBytes(StandardCharsets.UTF_8);
    byte[] content = new byte[2 + name.length + payload.length];
    content[0] = (byte) (name.length >> 8);
    content[1] = (byte) name.length;
    System.arraycopy(name, 0, content, 2, name.length);
    System.arraycopy(payload, 0, content, 2 + name.length, payload.length);
    send(RawClient.packet(0x30 | (retained ? 1 : 0), content));
  }

  private synchronized void send(byte[] packet) throws IOException {
    client.getOutputStream().write(packet);
  }

  @Override
  public void close() throws IOException {
    listening.close();
    synchronized (this) {
      if (client != null) {
        client.close();
      }
    }
    for (IOException fault : faults) {
      throw fault;
    }
  }
}
