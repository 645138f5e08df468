package org.u2sa.core.communication;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;

/** An MQTT client that says what no library would. */
final class RawClient implements AutoCloseable {
  private static final int USER_AND_PASSWORD = 0xc0; // flags of CONNECT
  private static final int CLEAN_SESSION = 0x02;

  private final Socket socket;
  private int keepAliveS = 60;
  private String willTopic; // null: none
  private byte[] will = {};
  private int willFlags;
  private byte[] last = {}; // content of the packet that was read last

  RawClient(int port) throws IOException {
    this(new Socket(), port);
  }

  /** Over a socket that is not connected yet, such as one of TLS. */
  RawClient(Socket socket, int port) throws IOException {
    this.socket = socket;
    socket.setReceiveBufferSize(8_192); // so that a client that does not read is soon full
    socket.setSoTimeout(20_000);
    socket.connect(new InetSocketAddress("127.0.0.1", port));
  }

  /** Sets the keep-alive interval of the CONNECT packet [s]. */
  RawClient keepingAlive(int seconds) {
    keepAliveS = seconds;
    return this;
  }

  /** Has the broker say this when the connection breaks. */
  RawClient willing(String topic, byte[] payload, boolean retained) {
    willTopic = topic;
    will = payload.clone();
    willFlags = 0x04 | 1 << 3 | (retained ? 0x20 : 0); // QoS 1
    return this;
  }

  /** Connects without a user and reads the answer. */
  RawClient introduced(String clientId) throws IOException {
    int code = introduce(clientId);
    if (code != 0) {
      throw new IOException("refused: " + code);
    }
    return this;
  }

  /** Connects and subscribes without waiting for an answer, as MQTT allows: the filter's code. */
  int introduceAndSubscribe(String clientId, String filter) throws IOException {
    ByteArrayOutputStream both = new ByteArrayOutputStream();
    both.write(packet(0x10, introduction(clientId)));
    both.write(packet(0x82, subscription(filter, 0)));
    send(both.toByteArray());
    byte[] answers = socket.getInputStream().readNBytes(9);
    return answers.length < 9 ? -1 : answers[8] & 0xff;
  }

  /**
   * Says who it is and reads the answer.
   *
   * @param userAndPassword both or none
   * @return the return code, 0 accepted; -1: put out without a word
   */
  int introduce(String clientId, String... userAndPassword) throws IOException {
    send(packet(0x10, introduction(clientId, userAndPassword)));
    byte[] answer = socket.getInputStream().readNBytes(4);
    return answer.length < 4 ? -1 : answer[3];
  }

  /** Ends as a process that is killed: the broker's next read fails. */
  void reset() throws IOException {
    socket.setSoLinger(true, 0);
    socket.close();
  }

  private byte[] introduction(String clientId, String... userAndPassword) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeUTF("MQTT");
    out.write(4); // 3.1.1
    out.write(CLEAN_SESSION | willFlags | (userAndPassword.length > 0 ? USER_AND_PASSWORD : 0));
    out.writeShort(keepAliveS);
    out.writeUTF(clientId);
    if (willTopic != null) {
      out.writeUTF(willTopic);
      out.writeShort(will.length);
      out.write(will);
    }
    for (String text : userAndPassword) {
      out.writeUTF(text);
    }
    return bytes.toByteArray();
  }

  /** Subscribes, QoS 0, and reads the answer: the code for the filter. */
  int subscribe(String filter) throws IOException {
    return subscribe(filter, 0);
  }

  int subscribe(String filter, int qos) throws IOException {
    send(packet(0x82, subscription(filter, qos)));
    return socket.getInputStream().readNBytes(5)[4] & 0xff;
  }

  /**
   * Subscribes, and reads whatever the broker answers until it is silent or ends the connection.
   */
  void trySubscribe(String filter) throws IOException {
    send(packet(0x82, subscription(filter, 0)));
    send(new byte[] {(byte) 0xe0, 0}); // DISCONNECT, after which the broker ends it
    isPutOut();
  }

  private static byte[] subscription(String filter, int qos) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeShort(1);
    out.writeUTF(filter);
    out.write(qos);
    return bytes.toByteArray();
  }

  /** QoS 1. */
  void publishRetained(String topic, byte[] payload) throws IOException {
    publish(topic, payload, 1, 1);
  }

  void publish(String topic, byte[] payload, int qos) throws IOException {
    publish(topic, payload, qos, 0);
  }

  private void publish(String topic, byte[] payload, int qos, int retain) throws IOException {
    byte[] name = topic.getBytes(StandardCharsets.UTF_8);
    byte[] all = new byte[2 + name.length + (qos > 0 ? 2 : 0) + payload.length];
    all[0] = (byte) (name.length >> 8);
    all[1] = (byte) name.length;
    System.arraycopy(name, 0, all, 2, name.length);
    if (qos > 0) {
      all[2 + name.length + 1] = 7;
    }
    System.arraycopy(payload, 0, all, all.length - payload.length, payload.length);
    send(packet(0x30 | qos << 1 | retain, all));
  }

  /** Reads one packet to its end. Returns its first byte: type and flags. */
  int next() throws IOException {
    InputStream in = socket.getInputStream();
    int first = in.read();
    int length = 0;
    int shift = 0;
    int digit;
    do {
      digit = in.read();
      length |= (digit & 0x7f) << shift;
      shift += 7;
    } while (digit > 0x7f);
    last = in.readNBytes(length);
    return first;
  }

  /** What the packet has that was read last, behind its length. */
  byte[] content() {
    return last.clone();
  }

  /** Reads a message of QoS 1. Returns its packet's identifier. */
  int nextMessage() throws IOException {
    int first = next();
    if (first >> 4 != 3 || (first >> 1 & 3) != 1) {
      throw new IOException("no message of QoS 1: " + Integer.toHexString(first));
    }
    int topicLength = (last[0] & 0xff) << 8 | last[1] & 0xff;
    return (last[2 + topicLength] & 0xff) << 8 | last[3 + topicLength] & 0xff;
  }

  /** Says goodbye and acknowledges a message after it, in one breath. */
  void acknowledgeAfterGoodbye(int identifier) throws IOException {
    send(new byte[] {(byte) 0xe0, 0, 0x40, 2, (byte) (identifier >> 8), (byte) identifier});
  }

  /** A packet: its first byte, its length, its content. */
  static byte[] packet(int type, byte[] content) throws IOException {
    ByteArrayOutputStream packet = new ByteArrayOutputStream();
    packet.write(type);
    int left = content.length;
    do {
      packet.write(left % 128 | (left >= 128 ? 0x80 : 0));
      left /= 128;
    } while (left > 0);
    packet.write(content);
    return packet.toByteArray();
  }

  void send(byte[] bytes) throws IOException {
    socket.getOutputStream().write(bytes);
  }

  /** Whether the broker ends the connection; reads what comes before. */
  boolean isPutOut() {
    try {
      byte[] chunk = new byte[65_536];
      while (socket.getInputStream().read(chunk) >= 0) {
        continue;
      }
      return true;
    } catch (SocketTimeoutException e) {
      return false;
    } catch (IOException e) {
      return true; // reset
    }
  }

  /** Whether the broker closes the connection while this client sends the given number of bytes. */
  boolean isPutOutWhileSending(int bytes) {
    try {
      for (int sent = 0; sent < bytes; sent += 1_024) {
        send(new byte[1_024]);
      }
      return isPutOut();
    } catch (IOException e) {
      return true; // reset
    }
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
