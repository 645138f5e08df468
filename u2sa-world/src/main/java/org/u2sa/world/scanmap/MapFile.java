package org.u2sa.world.scanmap;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.WholeFile;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.modeller.MapFrame;

/**
 * A saved map: gzip of a header, the map's frame and anchor, and the pose and wire-format scan of
 * each key scan.
 */
final class MapFile {
  /** A key scan of a file, not yet placed in a map. */
  record Saved(Pose2 pose, RangeScan scan) {}

  /** Contents of a file. */
  record Contents(MapFrame frame, List<Saved> scans) {}

  private static final String HEADER = "U2SA scan map 1";
  private static final int MAX_SCANS = 20_000;
  private static final int MAX_BYTES = 1 << 20; // maximum size of a scan
  private static final long HEAP_SHARE = 8; // part of the heap for all scans of a file

  private MapFile() {}

  /**
   * Writes a map; an existing one is replaced atomically.
   *
   * @throws IOException if it cannot be written, or would replace a file that is not a map
   */
  static void write(Path file, MapFrame frame, List<KeyScan> keys) throws IOException {
    boolean isFree = !Files.exists(file, LinkOption.NOFOLLOW_LINKS);
    if (!isFree && !isMap(file) && Files.size(file) > 0) {
      throw new IOException(file + " is not a map; expected a map, an empty file or no file");
    }
    MessageCodec codec = new MessageCodec(StandardTypes.registry());
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(new GZIPOutputStream(bytes))) {
      out.writeUTF(HEADER);
      out.writeUTF(frame.frame().name());
      out.writeDouble(frame.anchor().x());
      out.writeDouble(frame.anchor().y());
      out.writeDouble(frame.anchor().z());
      out.writeInt(keys.size());
      for (KeyScan key : keys) {
        out.writeDouble(key.pose().x());
        out.writeDouble(key.pose().y());
        out.writeDouble(key.pose().theta());
        byte[] scan = codec.encode(key.scan());
        out.writeInt(scan.length);
        out.write(scan);
      }
    }
    Path target = file.toAbsolutePath();
    Path temporary = Files.createTempFile(target.getParent(), target.getFileName() + ".", ".tmp");
    try {
      WholeFile.fillAndRename(temporary, bytes.toByteArray(), target);
    } finally {
      Files.deleteIfExists(temporary);
    }
  }

  private static boolean isMap(Path file) {
    if (!Files.isRegularFile(file)) {
      return false;
    }
    try (DataInputStream in = opened(file)) {
      return in.readUTF().equals(HEADER);
    } catch (IOException e) {
      return false;
    }
  }

  private static DataInputStream opened(Path file) throws IOException {
    return new DataInputStream(
        new BufferedInputStream(new GZIPInputStream(Files.newInputStream(file))));
  }

  /**
   * Reads a map.
   *
   * @throws BadInputException if the file is invalid, naming file and cause
   */
  static Contents read(Path file) {
    return read(file, Runtime.getRuntime().maxMemory() / HEAP_SHARE);
  }

  /**
   * @param maxBytes maximum size of all scans, unpacked
   */
  static Contents read(Path file, long maxBytes) {
    if (Files.exists(file) && !Files.isRegularFile(file)) {
      throw new BadInputException(file + ": expected a regular file"); // a pipe might block
    }
    try (DataInputStream in = opened(file)) {
      String header = in.readUTF();
      if (!header.equals(HEADER)) {
        throw new IOException("begins with \"" + header + "\", expected \"" + HEADER + "\"");
      }
      MapFrame frame = frame(in.readUTF(), in.readDouble(), in.readDouble(), in.readDouble());
      int count = in.readInt();
      if (count < 1 || count > MAX_SCANS) {
        throw new IOException(count + " scans, expected 1 to " + MAX_SCANS);
      }
      MessageCodec codec = new MessageCodec(StandardTypes.registry());
      List<Saved> scans = new ArrayList<>();
      long left = maxBytes;
      for (int i = 0; i < count; i++) {
        Pose2 pose = new Pose2(in.readDouble(), in.readDouble(), in.readDouble());
        int length = in.readInt();
        left -= length;
        if (left < 0) {
          throw new IOException("its scans are longer than the " + maxBytes + " bytes allowed");
        }
        scans.add(saved(in, pose, length, codec));
      }
      return new Contents(frame, scans);
    } catch (IOException | IllegalArgumentException | MalformedMessageException e) {
      throw new BadInputException(file + ": not a readable map: " + e.getMessage());
    }
  }

  private static Saved saved(DataInputStream in, Pose2 pose, int length, MessageCodec codec)
      throws IOException, MalformedMessageException {
    if (!Double.isFinite(pose.x() + pose.y() + pose.theta()) || length < 0 || length > MAX_BYTES) {
      throw new IOException("a scan of " + length + " bytes at " + pose);
    }
    byte[] bytes = new byte[length];
    in.readFully(bytes);
    U2SAData scan = codec.decode(RangeScan.TYPE.chain(), bytes);
    if (!(scan instanceof RangeScan range) || !range.referenceFrame().isBody()) {
      throw new IOException("an invalid scan, or one not in the vehicle's frame");
    }
    return new Saved(pose, range);
  }

  private static MapFrame frame(String name, double x, double y, double z) {
    HandOver state = new HandOver(MapFile.class.getName());
    state.text("MAP FRAME", name);
    state.number("ANCHOR X", x).number("ANCHOR Y", y).number("ANCHOR Z", z);
    return MapFrame.takenOver(state).orElseThrow();
  }
}
