import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Type;

/** What enjarify leaves out, as dex_annotations.py reads it from the dex files: annotations at run time, their defaults, names of parameters. */
final class DexAnnotations {
  private final Map<String, List<Consumer<ClassVisitor>>> ofClasses = new HashMap<>();
  private final Map<String, List<Consumer<MethodVisitor>>> ofMethods = new HashMap<>(); // by class, name and descriptor, or without descriptor

  static DexAnnotations read(InputStream stream) throws IOException {
    DexAnnotations all = new DexAnnotations();
    DataInputStream in = new DataInputStream(stream);
    for (int kind = in.read(); kind >= 0; kind = in.read()) {
      String owner = in.readUTF();
      switch (kind) {
        case 'K' -> all.ofClass(owner, in);
        case 'D' -> all.defaults(owner, in);
        case 'N' -> all.names(owner, in);
        case 'P' -> all.ofParameter(owner, in);
        default -> throw new IOException("annotations: record of kind " + kind);
      }
    }
    return all;
  }

  /** Adds a class's own annotations. */
  void visit(String name, ClassVisitor out) {
    ofClasses.getOrDefault(name, List.of()).forEach(each -> each.accept(out));
  }

  /** Adds those of a method and its parameters, before its code. */
  void visit(String owner, String name, String descriptor, MethodVisitor out) {
    ofMethods.getOrDefault(owner + '.' + name + descriptor, List.of()).forEach(each -> each.accept(out));
    ofMethods.getOrDefault(owner + '.' + name, List.of()).forEach(each -> each.accept(out));
  }

  private void ofClass(String owner, DataInputStream in) throws IOException {
    String type = in.readUTF();
    Consumer<AnnotationVisitor> elements = elements(in);
    ofClasses.computeIfAbsent(owner, key -> new ArrayList<>()).add(out -> elements.accept(out.visitAnnotation(type, true)));
  }

  private void defaults(String owner, DataInputStream in) throws IOException {
    in.readUTF(); // the owner's type
    for (int left = in.readUnsignedShort(); left > 0; left--) {
      String element = in.readUTF();
      Value value = value(in);
      add(
          owner + '.' + element,
          out -> {
            AnnotationVisitor annotation = out.visitAnnotationDefault();
            value.write(null, annotation);
            annotation.visitEnd();
          });
    }
  }

  private void names(String owner, DataInputStream in) throws IOException {
    String method = owner + '.' + in.readUTF() + in.readUTF();
    for (int left = in.readUnsignedShort(); left > 0; left--) {
      String name = in.readUTF();
      add(method, out -> out.visitParameter(name, 0));
    }
  }

  private void ofParameter(String owner, DataInputStream in) throws IOException {
    String method = owner + '.' + in.readUTF() + in.readUTF();
    int index = in.readUnsignedShort();
    String type = in.readUTF();
    Consumer<AnnotationVisitor> elements = elements(in);
    add(method, out -> elements.accept(out.visitParameterAnnotation(index, type, true)));
  }

  private void add(String method, Consumer<MethodVisitor> what) {
    ofMethods.computeIfAbsent(method, key -> new ArrayList<>()).add(what);
  }

  /** A value on its way into an annotation's element, or with no name into an array or a default. */
  private interface Value {
    void write(String name, AnnotationVisitor out);
  }

  private static Consumer<AnnotationVisitor> elements(DataInputStream in) throws IOException {
    Map<String, Value> elements = new HashMap<>();
    for (int left = in.readUnsignedShort(); left > 0; left--) {
      elements.put(in.readUTF(), value(in));
    }
    return out -> {
      elements.forEach((name, value) -> value.write(name, out));
      out.visitEnd();
    };
  }

  private static Value value(DataInputStream in) throws IOException {
    int tag = in.readUnsignedByte();
    switch (tag) {
      case '[' -> {
        List<Value> values = new ArrayList<>();
        for (int left = in.readUnsignedShort(); left > 0; left--) {
          values.add(value(in));
        }
        return (name, out) -> {
          AnnotationVisitor array = out.visitArray(name);
          values.forEach(each -> each.write(null, array));
          array.visitEnd();
        };
      }
      case '@' -> {
        String type = in.readUTF();
        Consumer<AnnotationVisitor> elements = elements(in);
        return (name, out) -> elements.accept(out.visitAnnotation(name, type));
      }
      case 'e' -> {
        String type = in.readUTF();
        String constant = in.readUTF();
        return (name, out) -> out.visitEnum(name, type, constant);
      }
      default -> {
        Object value = plain(tag, in);
        return (name, out) -> out.visit(name, value);
      }
    }
  }

  private static Object plain(int tag, DataInputStream in) throws IOException {
    if (tag == 's') {
      return in.readUTF();
    }
    if (tag == 'c') {
      return Type.getType(in.readUTF());
    }
    long bits = in.readLong();
    return switch (tag) {
      case 'Z' -> bits != 0;
      case 'B' -> (byte) bits;
      case 'S' -> (short) bits;
      case 'C' -> (char) bits;
      case 'I' -> (int) bits;
      case 'J' -> bits;
      case 'F' -> Float.intBitsToFloat((int) bits);
      case 'D' -> Double.longBitsToDouble(bits);
      default -> throw new IOException("annotations: value of kind " + tag);
    };
  }
}
