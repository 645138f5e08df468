package org.u2sa.core.communication;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * A broker of another make for one client: it holds some messages and hands each, with MQTT's
 * retained flag, to a subscription that begins with the same channel.
 */
final class RetainingBroker implements AutoCloseable {
  private static final int FIRST_LEVELS = 3; // u2sa, system, channel

  private final ServerSocket listening;
  private final Map<String, byte[]> held = new LinkedHashMap<>();
  private final List<IOException> faults = new CopyOnWriteArrayList<>();
  private final Thread thread = new Thread(this::serve, "retaining-broker");
  private Socket client; // written under this

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
        answer(first >> 4, in.readNBytes(length(in)));
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

  private void answer(int type, byte[] content) throws IOException {
    switch (type) {
      case 1: // CONNECT
        send(new byte[] {0x20, 2, 0, 0});
        break;
      case 8: // SUBSCRIBE, of one filter
        send(new byte[] {(byte) 0x90, 3, content[0], content[1], 1});
        handOver(new String(content, 4, content.length - 5, StandardCharsets.UTF_8));
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
    byte[] packet = new byte[4 + name.length + payload.length];
    packet[0] = (byte) (0x30 | (retained ? 1 : 0));
    packet[1] = (byte) (2 + name.length + payload.length); // below 128
    packet[3] = (byte) name.length;
    System.arraycopy(name, 0, packet, 4, name.length);
    System.arraycopy(payload, 0, packet, 4 + name.length, payload.length);
    send(packet);
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
