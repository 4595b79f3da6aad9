// The sum of eight terms, in a tree of 7 adders, 3 clocks late. The whole sum fits WIDTH bits.
`default_nettype none

module sum8 #(
    parameter WIDTH = 32
) (
    input  wire               clock,
    input  wire [8*WIDTH-1:0] terms,
    output wire [WIDTH-1:0]   sum
);
    wire [4*WIDTH-1:0] pairs;
    wire [2*WIDTH-1:0] quads;
    genvar             i;

    generate
        for (i = 0; i < 4; i = i + 1) begin : pair
            add #(.WIDTH(WIDTH)) adder (clock, terms[2*i*WIDTH +: WIDTH],
                terms[(2*i+1)*WIDTH +: WIDTH], pairs[i*WIDTH +: WIDTH]);
        end
        for (i = 0; i < 2; i = i + 1) begin : quad
            add #(.WIDTH(WIDTH)) adder (clock, pairs[2*i*WIDTH +: WIDTH],
                pairs[(2*i+1)*WIDTH +: WIDTH], quads[i*WIDTH +: WIDTH]);
        end
    endgenerate
    add #(.WIDTH(WIDTH)) adder (clock, quads[0 +: WIDTH], quads[WIDTH +: WIDTH], sum);
endmodule
