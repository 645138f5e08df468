"""Messages as pyubx2 makes them, for UbxGoldenTest: a name and the bytes of each.

pip install pyubx2==1.4.0; python3 ubx_golden.py > ubx.txt
"""
from pyubx2 import GET, SET, UBXMessage


def say(name, message):
    print(f"{name} {message.serialize().hex()}")


# What the receiver is told: 9600 baud, UBX and NMEA in, UBX out; 5 Hz; four messages, each solution.
port = UBXMessage(
    "CFG", "CFG-PRT", SET, portID=1, charLen=3, parity=4, nStopBits=0, baudRate=9600, inUBX=1, inNMEA=1, outUBX=1
)
payload = bytearray(port.payload)
payload[4] |= 0x10  # reserved; 1 for compatibility with ANTARIS 4, says the protocol's description
say("CFG-PRT", UBXMessage("CFG", "CFG-PRT", SET, payload=bytes(payload)))
say("CFG-RATE", UBXMessage("CFG", "CFG-RATE", SET, measRate=200, navRate=1, timeRef=1))
for msg_class, msg_id in ((0x01, 0x02), (0x01, 0x12), (0x01, 0x06), (0x01, 0x07)):
    say(
        f"CFG-MSG-{msg_class:02X}{msg_id:02X}",
        UBXMessage("CFG", "CFG-MSG", SET, payload=bytes([msg_class, msg_id, 1])),
    )

# What it answers and sends.
say("ACK-ACK", UBXMessage("ACK", "ACK-ACK", GET, clsID=0x06, msgID=0x08))
say("ACK-NAK", UBXMessage("ACK", "ACK-NAK", GET, clsID=0x06, msgID=0x01))
say(
    "NAV-PVT",
    UBXMessage(
        "NAV",
        "NAV-PVT",
        GET,
        iTOW=561600000,
        fixType=3,
        gnssFixOk=1,
        numSV=11,
        lon=-80.4233567,
        lat=37.2295733,
        height=601234,
        hMSL=634251,
        hAcc=1414,
        vAcc=2500,
        velN=1250,
        velE=-750,
        velD=-125,
    ),
)
say(
    "NAV-POSLLH",
    UBXMessage(
        "NAV",
        "NAV-POSLLH",
        GET,
        iTOW=561600200,
        lon=-80.4233567,
        lat=-37.2295733,
        height=601234,
        hMSL=634251,
        hAcc=2828,
        vAcc=4000,
    ),
)
say("NAV-VELNED", UBXMessage("NAV", "NAV-VELNED", GET, iTOW=561600200, velN=125, velE=-75, velD=-12))
say("NAV-SOL", UBXMessage("NAV", "NAV-SOL", GET, iTOW=561600200, gpsFix=3, gpsfixOK=1, numSV=9))
say("NAV-STATUS", UBXMessage("NAV", "NAV-STATUS", GET, iTOW=561600200, gpsFix=3, gpsFixOk=1))
