"""The peers: how each sends bytes from one process to another on this machine. A listener calls arrived(bytes); a sender has send(bytes).

What would outlive the process has close().
"""
import ctypes
import os
import tempfile
import threading
from dataclasses import dataclass

TOPIC = "benchmark"


class Zmq:
    """ZeroMQ's publish and subscribe over TCP."""

    def __init__(self, port, _size, arrived):
        import zmq
        self._context = zmq.Context()
        if arrived is None:
            self._socket = self._context.socket(zmq.PUB)
            self._socket.setsockopt(zmq.SNDHWM, 0)  # unlimited: it learns late what has left, and with 1000 drops messages while 200 are on the way
            self._socket.connect(f"tcp://127.0.0.1:{port}")
            self.send = self._socket.send
        else:
            self._socket = self._context.socket(zmq.SUB)
            self._socket.subscribe(b"")
            self._socket.bind(f"tcp://127.0.0.1:{port}")
            threading.Thread(target=self._read, args=(arrived,), daemon=True).start()

    def _read(self, arrived):
        while True:
            arrived(self._socket.recv())


class Zenoh:
    """Zenoh from peer to peer over TCP, without scouting."""

    def __init__(self, port, _size, arrived):
        import zenoh
        config = zenoh.Config()
        config.insert_json5("mode", '"peer"')
        config.insert_json5("scouting/multicast/enabled", "false")
        config.insert_json5("listen/endpoints" if arrived else "connect/endpoints", f'["tcp/127.0.0.1:{port}"]')
        if not arrived:
            config.insert_json5("listen/endpoints", "[]")
        self._session = zenoh.open(config)
        if arrived is None:
            self.send = self._session.declare_publisher(TOPIC).put
        else:
            self._subscriber = self._session.declare_subscriber(TOPIC, lambda sample: arrived(sample.payload.to_bytes()))


class Dds:
    """Cyclone DDS, best effort, over loopback."""

    def __init__(self, _port, size, arrived):
        os.environ.setdefault("CYCLONEDDS_URI", "<General><Interfaces><NetworkInterface name='lo' multicast='false'/></Interfaces></General>"
                              "<Discovery><ParticipantIndex>auto</ParticipantIndex><Peers><Peer address='127.0.0.1'/></Peers></Discovery>")
        from cyclonedds.core import Listener, Policy, Qos
        from cyclonedds.domain import DomainParticipant
        from cyclonedds.idl import IdlStruct
        from cyclonedds.idl.types import array, uint8
        from cyclonedds.pub import DataWriter
        from cyclonedds.sub import DataReader
        from cyclonedds.topic import Topic

        @dataclass
        class Contents(IdlStruct):
            bytes: array[uint8, size]

        qos = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(1000))
        self._participant = DomainParticipant(0)
        topic = Topic(self._participant, TOPIC, Contents)
        if arrived is None:
            writer = DataWriter(self._participant, topic, qos=qos)
            self.send = lambda contents: writer.write(Contents(contents))
            return

        class Heard(Listener):
            def on_data_available(self, reader):
                for sample in reader.take(1000):
                    arrived(bytes(sample.bytes))

        self._reader = DataReader(self._participant, topic, qos=qos, listener=Heard())


class Nt4:
    """NetworkTables 4 of FRC robots: the listener is the server, and each value is flushed."""

    def __init__(self, port, _size, arrived):
        import ntcore
        self._instance = ntcore.NetworkTableInstance.create()
        options = ntcore.PubSubOptions(sendAll=True, keepDuplicates=True, periodic=0.005)
        topic = self._instance.getRawTopic("/" + TOPIC)
        if arrived is None:
            self._instance.startClient4("sender")
            self._instance.setServer("127.0.0.1", port)
            self._publisher = topic.publish("raw", options)
            self.send = self._send
        else:
            self._subscriber = topic.subscribe("raw", b"", options)
            self._instance.addListener(
                self._subscriber, ntcore.EventFlags.kValueAll, lambda event: arrived(event.data.value.getRaw()))
            self._instance.startServer("", "127.0.0.1", 0, port)

    def _send(self, contents):
        self._publisher.set(contents)
        self._instance.flush()


class Lcm:
    """LCM over UDP multicast that does not leave the machine."""

    def __init__(self, port, _size, arrived):
        import lcm
        self._lcm = lcm.LCM(f"udpm://239.255.76.67:{port}?ttl=0")
        if arrived is None:
            self.send = lambda contents: self._lcm.publish(TOPIC, contents)
        else:
            self._lcm.subscribe(TOPIC, lambda _channel, contents: arrived(contents)).set_queue_capacity(1000)
            threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        while True:
            self._lcm.handle()


class Iceoryx2:
    """iceoryx2 through shared memory; an event wakes the listener after each message. The oldest of 1000 unread ones gives way."""

    def __init__(self, port, size, arrived):
        import iceoryx2
        iceoryx2.set_log_level(iceoryx2.LogLevel.Error)
        node = iceoryx2.NodeBuilder.new().create(iceoryx2.ServiceType.Ipc)
        name = iceoryx2.ServiceName.new(f"{TOPIC}/{port}")
        messages = node.service_builder(name).publish_subscribe(iceoryx2.Slice[ctypes.c_uint8]).max_subscribers(1).subscriber_max_buffer_size(1000).open_or_create()
        events = node.service_builder(name).event().open_or_create()
        self._thread = None
        if arrived is None:
            self._publisher = messages.publisher_builder().initial_max_slice_len(size).create()
            self._notifier = events.notifier_builder().create()
            self.send = self._send
        else:
            self._subscriber = messages.subscriber_builder().create()
            self._listener = events.listener_builder().create()
            self._at_most = iceoryx2.Duration.from_millis(100)  # an event ends the wait at once
            self._open = True
            self._thread = threading.Thread(target=self._read, args=(arrived,), daemon=True)
            self._thread.start()

    def _send(self, contents):
        loan = self._publisher.loan_slice_uninit(len(contents))
        ctypes.memmove(loan.payload_ptr, contents, len(contents))
        loan.assume_init().send()
        self._notifier.notify()

    def _read(self, arrived):
        while self._open:
            self._listener.timed_wait(self._at_most)
            while (sample := self._subscriber.receive()) is not None:
                arrived(bytes(sample.payload().as_memory_view()))

    def close(self):
        """Removes its shared memory, which goes with the last references."""
        if self._thread:
            self._open = False
            self._thread.join()
        self.__dict__.clear()


class Ros1:
    """ROS 1's rospy over TCP, from the system's packages; the listener is the master too."""

    def __init__(self, port, _size, arrived):
        try:
            import rospy
            from rosmaster.master import Master
            from std_msgs.msg import UInt8MultiArray
        except ImportError as e:
            raise ImportError(f"{e}: apt-get install --no-install-recommends python3-rosmaster python3-rospy python3-std-msgs") from e
        self._logs = tempfile.TemporaryDirectory()
        os.environ.pop("ROS_HOSTNAME", None)  # takes precedence over ROS_IP
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1", ROS_LOG_DIR=self._logs.name)
        if arrived is not None:
            self._master = Master(port)
            self._master.start()
        rospy.init_node("sender" if arrived is None else "listener", log_level=rospy.WARN, disable_rosout=True, disable_signals=True)
        if arrived is None:
            publisher = rospy.Publisher(TOPIC, UInt8MultiArray, tcp_nodelay=True, queue_size=1000)
            self.send = lambda contents: publisher.publish(UInt8MultiArray(data=contents))
        else:
            self._subscriber = rospy.Subscriber(TOPIC, UInt8MultiArray, lambda message: arrived(message.data), tcp_nodelay=True)

    def close(self):
        self._logs.cleanup()


ALL = {"pyzmq": Zmq, "zenoh": Zenoh, "cyclonedds": Dds, "nt4": Nt4, "lcm": Lcm, "iceoryx2": Iceoryx2, "ros1": Ros1}
