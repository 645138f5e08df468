package org.u2sa.recorder.foxglove;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/** Foxglove types that messages are converted to, each with its compiled schema. */
enum FoxgloveSchema {
  LOCATION_FIX("LocationFix"),
  POSE_IN_FRAME("PoseInFrame"),
  FRAME_TRANSFORM("FrameTransform"),
  LASER_SCAN("LaserScan"),
  GRID("Grid"),
  COMPRESSED_IMAGE("CompressedImage"),
  SCENE_UPDATE("SceneUpdate"),
  LOG("Log");

  private static final int PIECE = 4096;

  private final String type;

  FoxgloveSchema(String type) {
    this.type = type;
  }

  String fullName() {
    return "foxglove." + type;
  }

  /** FileDescriptorSet of the type and everything it refers to. */
  byte[] descriptors() {
    try (InputStream in = FoxgloveSchema.class.getResourceAsStream(type + ".bin")) {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      byte[] piece = new byte[PIECE];
      for (int n = in.read(piece); n >= 0; n = in.read(piece)) {
        bytes.write(piece, 0, n);
      }
      return bytes.toByteArray();
    } catch (IOException e) {
      throw new UncheckedIOException(type + ".bin", e);
    }
  }
}
