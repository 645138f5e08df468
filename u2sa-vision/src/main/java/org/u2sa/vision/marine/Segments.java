package org.u2sa.vision.marine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.marine.Colour;

/**
 * Finds connected cells that differ from the background of their rows: in air by a saturated colour
 * of their own, or by brightness; under water, which tints everything, by any difference. Reuses
 * its buffers.
 */
final class Segments {
  private static final int HUES = 3;
  private static final double DOME = 0.6; // height of a dome, as a share of its width
  private static final int FEWEST = 14;
  private static final float CHROMA = 0.07f; // min. difference of a share of red, green or blue
  private static final float TINT = 0.09f; // min. relative difference of a tint under water
  private static final float SHADE = 0.22f; // min. relative difference in brightness under water
  private static final float SIGMAS = 6.0f; // multiple of the row's own variation (MAD)
  private static final float DIM = 0.012f; // below this, hue is noise
  private static final byte ANY = 100; // under water

  private final LinearPicture picture;
  private byte[] paint = new byte[0];
  private int[] label = new int[0];
  private int[] parent = new int[256];
  private int reach = 1; // cells within which others belong to the same segment

  Segments(LinearPicture picture) {
    this.picture = picture;
  }

  /**
   * @param thin whether to join the pieces of lines thinner than a cell
   */
  List<Segment> find(boolean underWater, boolean thin) {
    reach = thin ? 2 : 1;
    int cells = picture.width * picture.height;
    if (paint.length != cells) {
      paint = new byte[cells];
      label = new int[cells];
    }
    for (int row = 0; row < picture.height; row++) {
      for (int column = 0; column < picture.width; column++) {
        int cell = row * picture.width + column;
        paint[cell] = underWater ? wet(row, HUES * cell) : dry(row, HUES * cell);
      }
    }
    return measured(join());
  }

  private byte dry(int row, int at) {
    float red = picture.cells[at];
    float green = picture.cells[at + 1];
    float blue = picture.cells[at + 2];
    float[] back = picture.median;
    int b = HUES * row;
    float sum = red + green + blue;
    float backSum = back[b] + back[b + 1] + back[b + 2];
    float bright = sum / backSum;
    float off = 0.0f;
    for (int hue = 0; hue < HUES; hue++) {
      off = Math.max(off, Math.abs(picture.cells[at + hue] / sum - back[b + hue] / backSum));
    }
    boolean isTinted = off > CHROMA && sum > DIM;
    boolean isShaded = bright > 1.6f || bright < 0.45f;
    if (!isTinted && !isShaded) {
      return 0;
    }
    Colour colour = Paints.name(red, green, blue, bright).orElse(null);
    boolean isPlain = colour == Colour.WHITE || colour == Colour.BLACK;
    return colour == null || !isPlain && !isTinted ? 0 : (byte) (colour.ordinal() + 1);
  }

  private byte wet(int row, int at) {
    int b = HUES * row;
    float mean = 0.0f;
    float rough = 0.0f;
    for (int hue = 0; hue < HUES; hue++) {
      mean += picture.cells[at + hue] / picture.median[b + hue] / HUES;
      rough += picture.spread[b + hue] / HUES;
    }
    if (Math.abs(mean - 1.0f) > Math.max(SHADE, SIGMAS * rough)) {
      return ANY;
    }
    for (int hue = 0; hue < HUES; hue++) {
      float tint = Math.abs(picture.cells[at + hue] / picture.median[b + hue] - mean);
      // a common change in brightness, e.g. by caustics, leaves tints unchanged
      if (tint > Math.max(TINT, 0.6f * SIGMAS * picture.spread[b + hue])) {
        return ANY;
      }
    }
    return 0;
  }

  private int join() {
    int labels = 0;
    int width = picture.width;
    for (int row = 0; row < picture.height; row++) {
      for (int column = 0; column < width; column++) {
        int cell = row * width + column;
        if (paint[cell] == 0) {
          continue;
        }
        int own = -1;
        for (int up = 0; up <= Math.min(reach, row); up++) {
          int last = up == 0 ? -1 : reach;
          for (int side = -reach; side <= last; side++) {
            int to = column + side;
            int other = cell - up * width + side;
            if (to >= 0 && to < width && paint[other] == paint[cell]) {
              int root = root(label[other]);
              if (own >= 0 && own != root) {
                parent[Math.max(own, root)] = Math.min(own, root);
                own = Math.min(own, root);
              } else {
                own = root;
              }
            }
          }
        }
        if (own < 0) {
          if (labels == parent.length) {
            parent = Arrays.copyOf(parent, 2 * labels);
          }
          parent[labels] = labels;
          own = labels++;
        }
        label[cell] = own;
      }
    }
    return labels;
  }

  private int root(int of) {
    int root = of;
    while (parent[root] != root) {
      parent[root] = parent[parent[root]];
      root = parent[root];
    }
    return root;
  }

  private List<Segment> measured(int labels) {
    int[] counts = new int[labels];
    int[] box = new int[4 * labels];
    for (int i = 0; i < labels; i++) {
      box[4 * i] = Integer.MAX_VALUE;
      box[4 * i + 1] = Integer.MAX_VALUE;
    }
    for (int row = 0; row < picture.height; row++) {
      for (int column = 0; column < picture.width; column++) {
        int cell = row * picture.width + column;
        if (paint[cell] != 0) {
          int own = root(label[cell]);
          label[cell] = own;
          counts[own]++;
          box[4 * own] = Math.min(box[4 * own], column);
          box[4 * own + 1] = Math.min(box[4 * own + 1], row);
          box[4 * own + 2] = Math.max(box[4 * own + 2], column);
          box[4 * own + 3] = row;
        }
      }
    }
    List<Segment> segments = new ArrayList<>();
    for (int i = 0; i < labels; i++) {
      if (counts[i] >= FEWEST) {
        segments.add(measured(i, counts[i], Arrays.copyOfRange(box, 4 * i, 4 * i + 4)));
      }
    }
    return segments;
  }

  private Segment measured(int own, int count, int[] box) {
    double sx = 0.0;
    double sy = 0.0;
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    double[] colour = new double[HUES];
    double[] around = new double[HUES];
    int inner = 0;
    int code = 0;
    int[][] rows = new int[box[3] - box[1] + 1][];
    for (int row = box[1]; row <= box[3]; row++) {
      int first = -1;
      int last = -1;
      int inRow = 0;
      for (int column = box[0]; column <= box[2]; column++) {
        int cell = row * picture.width + column;
        if (paint[cell] == 0 || label[cell] != own) {
          continue;
        }
        code = paint[cell];
        first = first < 0 ? column : first;
        last = column;
        inRow++;
        sx += column;
        sy += row;
        xx += (double) column * column;
        yy += (double) row * row;
        xy += (double) column * row;
        boolean isInner = isOwn(cell - 1, own) && isOwn(cell + 1, own);
        if (isInner || count < 2 * FEWEST || inner == 0) {
          inner++;
          for (int hue = 0; hue < HUES; hue++) {
            colour[hue] += picture.cells[HUES * cell + hue];
          }
        }
      }
      rows[row - box[1]] = new int[] {last - first + (first < 0 ? 0 : 1), row, first + last, inRow};
      for (int hue = 0; hue < HUES; hue++) {
        around[hue] += picture.median[HUES * row + hue] / rows.length;
      }
    }
    for (int hue = 0; hue < HUES; hue++) {
      colour[hue] /= Math.max(1, inner);
    }
    double x = sx / count;
    double y = sy / count;
    double cxx = xx / count - x * x + 1.0 / 12.0;
    double cyy = yy / count - y * y + 1.0 / 12.0;
    double cxy = xy / count - x * y;
    double half = Math.hypot(0.5 * (cxx - cyy), cxy);
    double mid = 0.5 * (cxx + cyy);
    return new Segment(
        code == ANY ? 0 : code,
        box[0],
        box[1],
        box[2],
        box[3],
        count,
        dome(rows),
        x,
        y,
        Math.sqrt(mid + half),
        Math.sqrt(Math.max(0.0, mid - half)),
        0.5 * Math.atan2(2.0 * cxy, cxx - cyy),
        isOpen(box, own),
        colour,
        around);
  }

  /** Dome of rows of width, row, sum of first and last column, and count. */
  private static Segment.Dome dome(int[][] rows) {
    int widest = 0;
    int height = 0;
    while (height < rows.length && height <= DOME * widest + 1.0) {
      widest = Math.max(widest, rows[height][0]);
      height++;
    }
    int[][] upper = Arrays.copyOf(rows, height);
    int count = 0;
    for (int[] row : upper) {
      count += row[3];
    }
    Arrays.sort(upper, (a, b) -> Integer.compare(b[0], a[0]));
    int[] wide = upper[height > 5 ? 1 : 0];
    return new Segment.Dome(
        wide[0], wide[1], 0.5 * wide[2], height, count / Math.max(1.0, height * (double) wide[0]));
  }

  private boolean isOwn(int cell, int own) {
    return cell >= 0 && cell < paint.length && paint[cell] != 0 && label[cell] == own;
  }

  /** Whether less than a tenth of the middle third of the box belongs to the segment. */
  private boolean isOpen(int[] box, int own) {
    int across = (box[2] - box[0]) / 6;
    int tall = (box[3] - box[1]) / 6;
    int inside = 0;
    int all = 0;
    for (int row = (box[1] + box[3]) / 2 - tall; row <= (box[1] + box[3]) / 2 + tall; row++) {
      int middle = row * picture.width + (box[0] + box[2]) / 2;
      for (int cell = middle - across; cell <= middle + across; cell++) {
        all++;
        inside += isOwn(cell, own) ? 1 : 0;
      }
    }
    return 10 * inside < all;
  }

  /** Cells of a segment's box that are more like its middle than like the background. */
  int likeMiddle(Segment segment, double[] middle) {
    int count = 0;
    double apart = 0.0;
    for (int hue = 0; hue < HUES; hue++) {
      apart += square(middle[hue] - segment.around()[hue]);
    }
    for (int row = segment.top(); row <= segment.bottom(); row++) {
      for (int column = segment.left(); column <= segment.right(); column++) {
        double off = 0.0;
        for (int hue = 0; hue < HUES; hue++) {
          off += square(picture.cells[HUES * (row * picture.width + column) + hue] - middle[hue]);
        }
        count += off < 0.25 * apart ? 1 : 0;
      }
    }
    return count;
  }

  private static double square(double value) {
    return value * value;
  }

  /** Mean colour of the middle of a segment: linear red, green, blue. */
  double[] middle(Segment segment) {
    int across = Math.max(0, segment.width() / 8);
    int tall = Math.max(0, segment.height() / 8);
    double[] sum = new double[HUES];
    int count = 0;
    for (int row = (int) segment.y() - tall; row <= (int) segment.y() + tall; row++) {
      for (int column = (int) segment.x() - across;
          column <= (int) segment.x() + across;
          column++) {
        count++;
        for (int hue = 0; hue < HUES; hue++) {
          sum[hue] += picture.cells[HUES * (row * picture.width + column) + hue];
        }
      }
    }
    for (int hue = 0; hue < HUES; hue++) {
      sum[hue] /= count;
    }
    return sum;
  }
}
