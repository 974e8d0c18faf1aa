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


ORDER = '{"type":"order","id":1,"label":'
REFUSED = [
    #  each with one of these in the place of the _
    ("_", 'x [] {} {"type":"pong","n":1} {"type":["ping"],"n":1} {"type":"ping"}'),
    ('{"type":"ping","n":_}', '1.5 true NaN 1,"hidden":"no" ' + "9" * 400),
    (ORDER + "_}", r'"XXXX" "RLDW" ["RGFW"] "RGFW\nRSWW" "RMOV" "MGTO"'),
    (ORDER + '"RMOV","value":_}', '"5" 1e9 1000001'),
    (ORDER + '"RGFW","value":_}', "5"),
    (ORDER + '"MGTO","points":_}', "[] [[1,2],[3,4]]"),
    (ORDER + '"MGCM","points":_}', "[[1,2],[3,4]]"),
    (ORDER + '"MABT","points":_}', "[[1,2]]"),
    (
        ORDER + '"MPTH","points":_}',
        '{"1":2} [1,2] [[1]] [[1,2,3]] [[1,"2"]] [[1,true]] [[1,null]] [[1,1e999]]'
        ' [[1,-9999.1]] [[1,2]],"value":3 [' + ",".join(["[1,2]"] * 65) + "]",
    ),
    ('{"type":"wheel","do":_}', '"steal" ["take"] "give" "offer"'),
    ('{"type":"pupil","do":_}', '"expel" ["mute"],"to":3'),
    ('{"type":"name","name":_}', r'"" "a\u202eb" "' + "a" * 31 + '"'),
]


@pytest.mark.parametrize(
    "text",
    [
        *("", "[" * 4000, '{"type":"order","label":"RGFW"}'),
        *('{"type":"name"}', '{"type":"name","name":"   "}'),
        *(form.replace("_", one) for form, many in REFUSED for one in many.split()),
    ],
)
def test_refused(text: str) -> None:
    with pytest.raises(Malformed):
        messages.read(text)
