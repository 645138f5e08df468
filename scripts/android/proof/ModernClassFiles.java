import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Enumeration;
import java.util.HashMap;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Lifts the class files of enjarify, which are Java 5's, to Java 8's: only there may interfaces have methods with code, as they have in dex.
 * Instructions stay as they are. Adds the frames that the virtual machine's verifier asks for, and says of each called method whether it is an
 * interface's, and what {@link DexAnnotations} has. Run as {@code java -cp asm.jar:. ModernClassFiles FROM.jar TO.jar}.
 */
final class ModernClassFiles {
  private static final String OBJECT = "java/lang/Object";

  /** What is known of a class without loading it. */
  private record Outline(boolean isInterface, String parent) {}

  private final Map<String, byte[]> classes = new HashMap<>();
  private final Map<String, Outline> outlines = new HashMap<>();
  private DexAnnotations annotations;

  public static void main(String[] args) throws IOException {
    ModernClassFiles files = new ModernClassFiles();
    files.read(Path.of(args[0]));
    files.write(Path.of(args[1]));
  }

  private void read(Path jar) throws IOException {
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      try (InputStream in = zip.getInputStream(zip.getEntry("annotations"))) {
        annotations = DexAnnotations.read(new BufferedInputStream(in));
      }
      for (Enumeration<? extends ZipEntry> all = zip.entries(); all.hasMoreElements(); ) {
        ZipEntry entry = all.nextElement();
        String name = entry.getName();
        if (name.endsWith(".class")) {
          try (InputStream in = zip.getInputStream(entry)) {
            classes.put(name.substring(0, name.length() - ".class".length()), in.readAllBytes());
          }
        }
      }
    }
  }

  private void write(Path jar) throws IOException {
    try (OutputStream out = Files.newOutputStream(jar);
        ZipOutputStream zip = new ZipOutputStream(out)) {
      for (Map.Entry<String, byte[]> file : classes.entrySet()) {
        zip.putNextEntry(new ZipEntry(file.getKey() + ".class"));
        zip.write(lifted(file.getValue()));
      }
    }
    System.out.println(classes.size() + " class files written");
  }

  private byte[] lifted(byte[] file) {
    ClassWriter writer =
        new ClassWriter(ClassWriter.COMPUTE_FRAMES) {
          @Override
          protected String getCommonSuperClass(String one, String other) {
            return commonParent(one, other);
          }
        };
    new ClassReader(file)
        .accept(
            new ClassVisitor(Opcodes.ASM9, writer) {
              private String owner;

              @Override
              public void visit(int version, int access, String name, String signature, String parent, String[] interfaces) {
                super.visit(Opcodes.V1_8, access, name, signature, parent, interfaces);
                owner = name;
                annotations.visit(name, cv);
              }

              @Override
              public MethodVisitor visitMethod(int access, String name, String descriptor, String signature, String[] exceptions) {
                MethodVisitor method = super.visitMethod(access, name, descriptor, signature, exceptions);
                annotations.visit(owner, name, descriptor, method);
                return new MethodVisitor(Opcodes.ASM9, method) {
                  @Override
                  public void visitMethodInsn(int opcode, String owner, String method, String type, boolean isInterface) {
                    boolean array = owner.startsWith("[");
                    super.visitMethodInsn(opcode, owner, method, type, !array && (isInterface || outline(owner).isInterface()));
                  }
                };
              }
            },
            ClassReader.SKIP_FRAMES);
    return writer.toByteArray();
  }

  private String commonParent(String one, String other) {
    if (outline(one).isInterface() || outline(other).isInterface()) {
      return OBJECT;
    }
    for (String parent = one; parent != null; parent = outline(parent).parent()) {
      for (String candidate = other; candidate != null; candidate = outline(candidate).parent()) {
        if (candidate.equals(parent)) {
          return parent;
        }
      }
    }
    return OBJECT;
  }

  private Outline outline(String name) {
    return outlines.computeIfAbsent(name, this::look);
  }

  private Outline look(String name) {
    try {
      byte[] file = classes.get(name);
      if (file == null) {
        try (InputStream in = ClassLoader.getSystemResourceAsStream(name + ".class")) {
          if (in == null) {
            return new Outline(false, OBJECT); // Android's, or a library's that is not there: nobody comes to load it
          }
          file = in.readAllBytes();
        }
      }
      ClassReader reader = new ClassReader(file);
      return new Outline((reader.getAccess() & Opcodes.ACC_INTERFACE) != 0, reader.getSuperName());
    } catch (IOException e) {
      throw new IllegalStateException(name + ": cannot be read: " + e.getMessage(), e);
    }
  }
}
