"""Services of the Universal Unmanned Systems Architecture in Python (docs/python.md)."""
from .codec import decode, encode
from .configuration import BadConfiguration, Configuration, Variable
from .emergency import EmergencyLatch
from .link import Broker, CannotConnect, Link
from .message import Message
from .schema import Field, Malformed, MessageType, Schema
from .service import Service
from .topics import Topic

__all__ = ["BadConfiguration", "Broker", "CannotConnect", "Configuration", "EmergencyLatch", "Field", "Link",
           "Malformed", "Message", "MessageType", "Schema", "Service", "Topic", "Variable", "decode", "encode"]
__version__ = "0.1.0"
