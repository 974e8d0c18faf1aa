#  SPDX-License-Identifier: GPL-3.0-or-later
"""What a page may say."""

import pytest
from destijl_web import messages
from destijl_web.messages import Malformed, Name, Order, Ping, Pupil, Seen, Wheel


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"type":"ping","n":7,"hidden":false}', Ping(7, False)),
        ('{"type":"ping","n":7,"hidden":true}', Ping(7, True)),
        ('{"type":"seen"}', Seen()),
        ('{"type":"order","id":1,"label":"RGFW"}', Order(1, "RGFW", None)),
        ('{"type":"order","id":1,"label":"RGFW","value":null}', Order(1, "RGFW", None)),
        ('{"type":"order","id":1,"label":"RTRN","value":-90}', Order(1, "RTRN", -90)),
        (
            '{"type":"order","id":1,"label":"MGTO","points":[[320,240.5]]}',
            Order(1, "MGTO", None, ((320.0, 240.5),)),
        ),
        (
            '{"type":"order","id":1,"label":"MPCM","points":[[-1,2],[9999,-9999.0]]}',
            Order(1, "MPCM", None, ((-1.0, 2.0), (9999.0, -9999.0))),
        ),
        ('{"type":"wheel","do":"take"}', Wheel("take", None)),
        ('{"type":"wheel","do":"give","to":3}', Wheel("give", 3)),
        ('{"type":"wheel","do":"offer","to":3}', Wheel("offer", 3)),
        ('{"type":"wheel","do":"withdraw"}', Wheel("withdraw", None)),
        ('{"type":"name","name":" Zoé "}', Name("Zoé")),
        ('{"type":"pupil","do":"unmute","to":3}', Pupil("unmute", 3)),
    ],
)
def test_read(text: str, message: messages.Message) -> None:
    assert messages.read(text) == message


@pytest.mark.parametrize(
    "text",
    [
        "",
        "x",
        "[]",
        "[" * 4000,
        "{}",
        '{"type":"pong","n":1}',
        '{"type":["ping"],"n":1}',
        '{"type":"ping"}',
        '{"type":"ping","n":1.5}',
        '{"type":"ping","n":true}',
        '{"type":"ping","n":NaN}',
        '{"type":"ping","n":' + "9" * 400 + "}",
        '{"type":"ping","n":1,"hidden":"no"}',
        '{"type":"order","id":1,"label":"XXXX"}',
        '{"type":"order","id":1,"label":"RLDW"}',
        '{"type":"order","id":1,"label":["RGFW"]}',
        '{"type":"order","id":1,"label":"RGFW\\nRSWW"}',
        '{"type":"order","label":"RGFW"}',
        '{"type":"order","id":1,"label":"RMOV"}',
        '{"type":"order","id":1,"label":"RMOV","value":"5"}',
        '{"type":"order","id":1,"label":"RMOV","value":1e9}',
        '{"type":"order","id":1,"label":"RMOV","value":1000001}',
        '{"type":"order","id":1,"label":"RGFW","value":5}',
        '{"type":"order","id":1,"label":"MGTO"}',
        '{"type":"order","id":1,"label":"MGTO","points":[]}',
        '{"type":"order","id":1,"label":"MGTO","points":[[1,2],[3,4]]}',
        '{"type":"order","id":1,"label":"MGCM","points":[[1,2],[3,4]]}',
        '{"type":"order","id":1,"label":"MPTH","points":{"1":2}}',
        '{"type":"order","id":1,"label":"MPTH","points":[1,2]}',
        '{"type":"order","id":1,"label":"MPTH","points":[[1]]}',
        '{"type":"order","id":1,"label":"MPTH","points":[[1,2,3]]}',
        '{"type":"order","id":1,"label":"MPTH","points":[[1,"2"]]}',
        '{"type":"order","id":1,"label":"MPTH","points":[[1,true]]}',
        '{"type":"order","id":1,"label":"MPTH","points":[[1,null]]}',
        '{"type":"order","id":1,"label":"MPTH","points":[[1,1e999]]}',
        '{"type":"order","id":1,"label":"MPTH","points":[[1,-9999.1]]}',
        '{"type":"order","id":1,"label":"MPTH","points":['
        + ",".join(["[1,2]"] * 65)
        + "]}",
        '{"type":"order","id":1,"label":"MPTH","points":[[1,2]],"value":3}',
        '{"type":"order","id":1,"label":"MABT","points":[[1,2]]}',
        '{"type":"wheel","do":"steal"}',
        '{"type":"wheel","do":["take"]}',
        '{"type":"wheel","do":"give"}',
        '{"type":"wheel","do":"offer"}',
        '{"type":"pupil","do":"expel"}',
        '{"type":"pupil","do":["mute"],"to":3}',
        '{"type":"name"}',
        '{"type":"name","name":""}',
        '{"type":"name","name":"   "}',
        '{"type":"name","name":"a\\u202eb"}',
        '{"type":"name","name":"' + "a" * 31 + '"}',
    ],
)
def test_refused(text: str) -> None:
    with pytest.raises(Malformed):
        messages.read(text)
