#!/usr/bin/env python3
"""A server that knows of Toqa nothing but docs/robot-link.md: it lets a robot drive one metre.

usage: server.py PORT         of a robot on loopback; prints where it ended, x and y
"""

import json
import math
import socket
import sys
import threading
import time


def main():
    robot = socket.create_connection(("127.0.0.1", int(sys.argv[1])))
    robot.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    lines = robot.makefile("rb")
    turn = threading.Lock()
    seq = 0

    def say(message):
        nonlocal seq
        with turn:
            seq += 1
            robot.sendall((json.dumps({**message, "seq": seq}) + "\n").encode())
            return seq

    def ping():
        while True:
            say({"type": "ping"})
            time.sleep(0.5)

    hello = json.loads(lines.readline())
    seq = hello["lastSeq"]
    start = hello["pose"]
    threading.Thread(target=ping, daemon=True).start()
    half = [{"v": 0.25, "w": 0.0, "t": 2.0}]
    drive = say({
        "type": "drive", "task": None, "phase": 0, "start": start, "segments": half + half,
        "released": 1, "final": True, "load": 0,
    })
    is_released = False
    for line in lines:
        message = json.loads(line)
        if message["type"] == "reject":
            sys.exit(message["reason"])
        if message["type"] == "state" and message["segment"] == 1 and not is_released:
            here = math.dist(
                (start["x"], start["y"]), (message["pose"]["x"], message["pose"]["y"]))
            if here > 0.53:
                sys.exit(f"It drove {here} m, and 0.5 m were released.")
            is_released = True
            say({"type": "release", "drive": drive, "released": 2})
        if message["type"] == "done" and message["drive"] == drive:
            robot.sendall((json.dumps({"type": "ack", "done": drive}) + "\n").encode())
            break
    for line in lines:
        message = json.loads(line)
        if message["type"] == "state" and message["mode"] == "IDLE":
            print(message["pose"]["x"], message["pose"]["y"])
            return


main()
